// SPDX-License-Identifier: MIT
#include "models/survey/sorting/scene_lists.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace cigsim::survey {
namespace {

std::vector<Record> first_lines(const FaceList& list) {
  std::vector<Record> records;
  for (std::uint32_t e = 0; e < list.edges.size(); ++e)
    records.push_back({static_cast<std::uint32_t>(list.edges[e].first_line), e});
  return records;
}

// A float's bits are ordered as its value, if that is not negative.
std::vector<Record> depths(const FaceList& list) {
  std::vector<Record> records;
  for (std::uint32_t f = 0; f < list.faces.size(); ++f) {
    const SurveyFace& face = list.faces[f];
    const RoundedPlane& plane = list.rounded[face.plane];
    double far = std::numeric_limits<double>::infinity();
    for (std::uint32_t p = 0; p < face.place_count; ++p) {
      const RasterPlace& at = list.places[face.first_place + p];
      far = std::min(far, plane.a * at.x.get_d() + plane.b * at.y.get_d() + plane.c);
    }
    records.push_back({std::bit_cast<std::uint32_t>(static_cast<float>(std::max(far, 0.0))), f});
  }
  return records;
}

std::uint32_t element(const FaceList& list, std::uint32_t e, int line) {
  const SurveyEdge& edge = list.edges[e];
  const Row& row = list.row(list.faces[edge.face], line);
  return edge.left ? row.first : row.end;
}

// Edges by the line on which they begin.
std::vector<std::vector<std::uint32_t>> edges_by_line(const FaceList& list) {
  std::vector<std::vector<std::uint32_t>> begin(static_cast<std::size_t>(list.raster.height));
  for (std::uint32_t e = 0; e < list.edges.size(); ++e)
    begin[static_cast<std::size_t>(list.edges[e].first_line)].push_back(e);
  return begin;
}

}  // namespace

std::vector<SortLists> scene_lists(const FaceList& list) {
  std::vector<SortLists> out{
      {"Y", "edges by first line", {}, 0},
      {"X, line to line", "crossings, in the order of the line before", {}, 0},
      {"X, afresh", "crossings, in the order of the database", {}, 0},
      {"Z", "faces by farthest depth, 32 bits", {}, 0}};
  out[0].lists.push_back(first_lines(list));
  out[3].lists.push_back(depths(list));
  const auto begin = edges_by_line(list);
  std::vector<Record> carried;
  for (int r = 0; r < list.raster.height; ++r) {
    std::erase_if(carried,
                  [&](const Record& record) { return list.edges[record.index].end_line <= r; });
    std::vector<Record> now = carried;
    for (Record& record : now) record.key = element(list, record.index, r);
    for (const std::uint32_t e : begin[static_cast<std::size_t>(r)]) {
      const Record record{element(list, e, r), e};
      now.insert(std::find_if(now.begin(), now.end(),
                              [&](const Record& other) { return other.key > record.key; }),
                 record);
    }
    std::vector<Record> afresh = now;
    std::sort(afresh.begin(), afresh.end(),
              [](const Record& a, const Record& b) { return a.index < b.index; });
    carried = now;
    std::stable_sort(carried.begin(), carried.end(),
                     [](const Record& a, const Record& b) { return a.key < b.key; });
    out[1].lists.push_back(std::move(now));
    out[2].lists.push_back(std::move(afresh));
  }
  for (SortLists& lists : out)
    for (const auto& records : lists.lists) lists.records += records.size();
  return out;
}

}  // namespace cigsim::survey
