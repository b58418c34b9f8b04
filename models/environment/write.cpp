// SPDX-License-Identifier: MIT
#include "models/environment/write.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <streambuf>
#include <vector>

#include "models/environment/input_error.hpp"
#include "models/environment/scene_writers.hpp"
#include "models/environment/text_file.hpp"

namespace cigsim {
namespace {

[[noreturn]] void fail(const std::filesystem::path& file, int reason) {
  std::string what = std::string("cannot be written (") + std::strerror(reason) + "); ";
  switch (reason) {
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
      what += "make room or name a file on another disk";
      break;
    case ENOENT:
    case ENOTDIR:
      what += "make its folder first";
      break;
    case EACCES:
    case EPERM:
    case EROFS:
      what += "name a file in a folder that you may write to";
      break;
    case EISDIR:
      what += "name a file inside that folder";
      break;
    default:
      what += "check the disk";
      break;
  }
  throw InputError(file.string(), 0, what);
}

/// A file that is being written. Remembers the first fault; std::ostream would lose its reason.
class FileBuffer : public std::streambuf {
 public:
  FileBuffer() : block_(1 << 18) { setp(block_.data(), block_.data() + block_.size()); }
  FileBuffer(const FileBuffer&) = delete;
  FileBuffer& operator=(const FileBuffer&) = delete;
  ~FileBuffer() override { close(); }

  bool open(const std::filesystem::path& file, int flags) {
    descriptor_ = ::open(file.c_str(), O_WRONLY | O_CLOEXEC | flags, 0666);
    return descriptor_ >= 0;
  }

  /// The errno of the first fault, 0 when every byte was taken.
  int close() {
    if (descriptor_ < 0) return reason_;
    sync();
    if (::close(descriptor_) != 0 && reason_ == 0) reason_ = errno;
    descriptor_ = -1;
    return reason_;
  }

 protected:
  int_type overflow(int_type c) override {
    if (sync() != 0) return traits_type::eof();
    if (!traits_type::eq_int_type(c, traits_type::eof())) sputc(traits_type::to_char_type(c));
    return traits_type::not_eof(c);
  }

  int sync() override {
    for (const char* at = pbase(); at != pptr() && reason_ == 0;) {
      const ssize_t written = ::write(descriptor_, at, static_cast<std::size_t>(pptr() - at));
      if (written >= 0)
        at += written;
      else if (errno != EINTR)
        reason_ = errno;
    }
    setp(block_.data(), block_.data() + block_.size());
    return reason_ == 0 ? 0 : -1;
  }

 private:
  std::vector<char> block_;
  int descriptor_ = -1;
  int reason_ = 0;
};

/// Removes a file unless it was kept.
struct Unfinished {
  std::filesystem::path file;
  bool kept = false;
  ~Unfinished() {
    if (!kept) ::unlink(file.c_str());
  }
};

int write_through(FileBuffer& buffer, const std::function<void(std::ostream&)>& write_contents) {
  std::ostream out(&buffer);
  write_contents(out);
  return buffer.close();
}

/// Opens a new file in the folder of `file`.
std::filesystem::path open_beside(const std::filesystem::path& file, FileBuffer& buffer) {
  static std::atomic<unsigned> count{0};
  while (true) {
    std::filesystem::path beside = file;
    std::string suffix(1, '.');
    suffix.append(std::to_string(::getpid())).append(1, '-');
    suffix.append(std::to_string(count++)).append(".part");
    beside += suffix;
    if (buffer.open(beside, O_CREAT | O_EXCL)) return beside;
    if (errno != EEXIST) fail(file, errno);
  }
}

}  // namespace

void write_file(const std::filesystem::path& file,
                const std::function<void(std::ostream&)>& write_contents) {
  FileBuffer buffer;
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (std::filesystem::is_directory(status)) fail(file, EISDIR);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    // A device or pipe, such as /dev/stdout, cannot be replaced by a renamed file.
    if (!buffer.open(file, 0)) fail(file, errno);
    if (const int reason = write_through(buffer, write_contents)) fail(file, reason);
    return;
  }
  const std::filesystem::path target =
      std::filesystem::is_symlink(std::filesystem::symlink_status(file, error))
          ? std::filesystem::weakly_canonical(file, error)
          : file;
  Unfinished unfinished{open_beside(target, buffer)};
  if (const int reason = write_through(buffer, write_contents)) fail(file, reason);
  if (::rename(unfinished.file.c_str(), target.c_str()) != 0) fail(file, errno);
  unfinished.kept = true;
}

void write_file(const std::filesystem::path& file, std::string_view contents) {
  write_file(file, [&](std::ostream& out) {
    out.write(contents.data(), static_cast<std::streamsize>(contents.size()));
  });
}

void write_environment(const Environment& environment, const std::filesystem::path& file) {
  const std::string ending = lower_ending(file);
  if (ending != "json" && ending != "cbor" && ending != "obj")
    throw InputError(file.string(), 0,
                     "scenes are written as .json, .cbor or .obj; choose one of these endings");
  write_file(file, [&](std::ostream& out) {
    if (ending == "obj") return write_obj(environment, out);
    const auto emitter = ending == "json" ? make_json_emitter(out) : make_cbor_emitter(out);
    write_scene(environment, *emitter);
  });
}

}  // namespace cigsim
