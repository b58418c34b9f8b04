// SPDX-License-Identifier: MIT
// Meshes of other programs through Assimp, which holds coordinates in single precision. One object
// a node that has meshes; vertices at the same place are one vertex, so that closed meshes are
// closed again after a format has split them by normals, texture or material.
//
// Axes: glTF and AC3D have y up and are turned; Assimp turns 3DS to y up, which is taken back; STL
// and OFF are taken as they stand.
#include <assimp/config.h>
#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <exception>
#include <limits>

#include "models/environment/input_error.hpp"
#include "models/environment/mesh_repair.hpp"
#include "models/environment/read.hpp"
#include "models/environment/text_file.hpp"

namespace cigsim {
namespace {

/// A node's transform into the scene, in double precision.
struct Transform {
  double m[3][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}};

  Transform then_inside(const aiMatrix4x4& inner) const {
    Transform product;
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 4; ++c) {
        double sum = c == 3 ? m[r][3] : 0;
        for (int k = 0; k < 3; ++k) sum += m[r][k] * static_cast<double>(inner[k][c]);
        product.m[r][c] = sum;
      }
    return product;
  }

  Vec3 operator*(const aiVector3D& v) const {
    const double x = v.x, y = v.y, z = v.z;
    return {m[0][0] * x + m[0][1] * y + m[0][2] * z + m[0][3],
            m[1][0] * x + m[1][1] * y + m[1][2] * z + m[1][3],
            m[2][0] * x + m[2][1] * y + m[2][2] * z + m[2][3]};
  }
};

std::string one_line(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
  return text;
}

class MeshReader {
 public:
  MeshReader(const std::filesystem::path& file, const aiScene& scene)
      : file_(file), scene_(scene), ending_(lower_ending(file)) {}

  ReadResult read() {
    Environment& environment = result_.environment;
    environment.name = file_.stem().string();
    environment.models.push_back({environment.name, 0});
    if (scene_.mRootNode) node(*scene_.mRootNode, Transform());
    if (environment.objects.empty()) fail("holds no object with faces; export a mesh of polygons");
    const auto notice = [&](const char* what, std::uint64_t count) {
      if (count > 0) result_.notices.push_back({what, count});
    };
    notice("points and lines dropped", dropped_elements_);
    notice("faces of fewer than three different vertices dropped", degenerate_faces_);
    notice("meshes without faces dropped", empty_nodes_);
    return std::move(result_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(file_.string(), 0, what);
  }

  /// Nodes may be nested deeply, so they wait in a list and not on the stack.
  void node(const aiNode& root, const Transform& outer) {
    std::vector<std::pair<const aiNode*, Transform>> waiting{{&root, outer}};
    while (!waiting.empty()) {
      const auto [current, parent] = waiting.back();
      waiting.pop_back();
      const Transform transform = parent.then_inside(current->mTransformation);
      if (current->mNumMeshes > 0) add_object(*current, transform);
      for (unsigned i = current->mNumChildren; i-- > 0;)
        waiting.emplace_back(current->mChildren[i], transform);
    }
  }

  void add_object(const aiNode& node, const Transform& transform) {
    Object object;
    object.name = one_line(node.mName.C_Str());
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
      if (node.mMeshes[i] >= scene_.mNumMeshes)
        fail("a node names a mesh that is not there; export the scene again");
      add_mesh(*scene_.mMeshes[node.mMeshes[i]], transform, object);
    }
    join_vertices(object);
    degenerate_faces_ += drop_degenerate_faces(object);
    if (object.faces.empty()) {
      ++empty_nodes_;
      return;
    }
    result_.environment.objects.push_back(std::move(object));
  }

  void add_mesh(const aiMesh& mesh, const Transform& transform, Object& object) {
    const std::size_t base = object.vertices.size();
    if (base + mesh.mNumVertices > std::numeric_limits<std::uint32_t>::max() - 1)
      fail("an object has more vertices than 2^32 - 2; split the scene");
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
      const Vec3 v = to_environment(transform * mesh.mVertices[i]);
      if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z))
        fail("vertex " + std::to_string(i + 1) + " of mesh \"" + one_line(mesh.mName.C_Str()) +
             "\" is not finite; correct its coordinates");
      object.vertices.push_back(v);
    }
    const std::optional<Colour> colour = diffuse(mesh);
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
      const aiFace& source = mesh.mFaces[i];
      if (source.mNumIndices < 3) {
        ++dropped_elements_;
        continue;
      }
      Face face{{}, colour};
      face.vertices.reserve(source.mNumIndices);
      for (unsigned k = 0; k < source.mNumIndices; ++k) {
        if (source.mIndices[k] >= mesh.mNumVertices)
          fail("face " + std::to_string(i + 1) + " of mesh \"" + one_line(mesh.mName.C_Str()) +
               "\" names vertex " + std::to_string(source.mIndices[k]) + " of " +
               std::to_string(mesh.mNumVertices) + ", counted from 0; correct the face");
        face.vertices.push_back(static_cast<std::uint32_t>(base + source.mIndices[k]));
      }
      object.faces.push_back(std::move(face));
    }
  }

  Vec3 to_environment(const Vec3& v) const {
    const bool y_up = ending_ == "gltf" || ending_ == "glb" || ending_ == "ac" || ending_ == "3ds";
    return y_up ? Vec3{v.x, 0 - v.z, v.y} : v;
  }

  /// The colour of the file's own material; Assimp's stand-in for a missing one has none.
  std::optional<Colour> diffuse(const aiMesh& mesh) const {
    if (mesh.mMaterialIndex >= scene_.mNumMaterials) return std::nullopt;
    const aiMaterial& material = *scene_.mMaterials[mesh.mMaterialIndex];
    aiString name;
    if (material.Get(AI_MATKEY_NAME, name) == aiReturn_SUCCESS &&
        name == aiString(AI_DEFAULT_MATERIAL_NAME))
      return std::nullopt;
    aiColor4D c;
    if (material.Get(AI_MATKEY_COLOR_DIFFUSE, c) != aiReturn_SUCCESS) return std::nullopt;
    const auto level = [](float value) {
      return static_cast<std::uint8_t>(value > 0 ? std::lround(255 * std::min(value, 1.0f)) : 0);
    };
    return Colour{level(c.r), level(c.g), level(c.b)};
  }

  std::filesystem::path file_;
  const aiScene& scene_;
  std::string ending_;
  ReadResult result_;
  std::uint64_t dropped_elements_ = 0, degenerate_faces_ = 0, empty_nodes_ = 0;
};

}  // namespace

ReadResult read_mesh(const std::filesystem::path& file) {
  read_whole_file(file);
  Assimp::Importer importer;
  // The faces that the file lists, not a surface subdivided from them.
  importer.SetPropertyBool(AI_CONFIG_IMPORT_AC_EVAL_SUBDIVISION, false);
  const aiScene* scene = nullptr;
  std::string reason;
  try {
    scene = importer.ReadFile(file.string(), 0);
    reason = importer.GetErrorString();
  } catch (const std::exception& error) {
    reason = error.what();
  }
  if (!scene)
    throw InputError(file.string(), 0,
                     "cannot be read (" + one_line(reason) + "); export it again or as .obj");
  return MeshReader(file, *scene).read();
}

}  // namespace cigsim
