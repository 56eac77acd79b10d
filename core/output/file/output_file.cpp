#include "core/output/file/output_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include "core/base/error.h"
#include "core/output/file/flush.h"

namespace nilas::output {

namespace {

constexpr mode_t k_file_mode = 0666;  // reduced by the user's umask

}  // namespace

OutputFile::OutputFile(std::filesystem::path path, std::string tail, std::optional<std::int64_t> keep, Pieces pieces)
    : path_(std::move(path)), tail_(std::move(tail)), pieces_(pieces) {
  descriptor_ = ::open(path_.c_str(), O_CLOEXEC | O_RDWR | (keep ? 0 : O_CREAT | O_TRUNC), k_file_mode);
  if (descriptor_ < 0) fail(errno);
  if (keep) cut_to(*keep);
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void OutputFile::append(std::string_view piece) {
  if (!tail_.empty()) buffer_.assign(piece).append(tail_);
  if (!write_at(body_end_, tail_.empty() ? piece : buffer_)) {
    const int error_number = errno;
    cut_back();
    fail(error_number);
  }
  body_end_ += static_cast<off_t>(piece.size());
}

void OutputFile::read(std::int64_t offset, std::span<std::byte> to) const {
  while (!to.empty()) {
    const ssize_t found = ::pread(descriptor_, to.data(), to.size(), static_cast<off_t>(offset));
    if (found < 0 && errno == EINTR) continue;
    if (found < 0) throw FileError(path_.string() + ": cannot read: " + std::strerror(errno));
    if (found == 0) throw FileError(path_.string() + ": cannot read: it has become shorter than what was written");
    offset += found;
    to = to.subspan(static_cast<std::size_t>(found));
  }
}

void OutputFile::sync() const {
  if (::fdatasync(descriptor_) != 0) fail(errno);
}

void OutputFile::close() {
  if (descriptor_ < 0) return;
  if (::close(std::exchange(descriptor_, -1)) != 0) fail(errno);
}

bool OutputFile::write_at(off_t offset, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::pwrite(descriptor_, text.data(), text.size(), offset);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    offset += written;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

void OutputFile::cut_back() {
  // The blocks of the old tail still belong to the file, so writing it again needs no new space. Errors are ignored
  // here: the user sees the one that led here.
  if (body_end_ > 0) write_at(body_end_, tail_);
  const off_t end = body_end_ > 0 ? body_end_ + static_cast<off_t>(tail_.size()) : 0;
  if (::ftruncate(descriptor_, end) != 0) return;
}

void OutputFile::cut_to(std::int64_t bytes) {
  const off_t size = ::lseek(descriptor_, 0, SEEK_END);
  if (size < 0) fail(errno);
  if (size < bytes)
    throw InputError(path_.string() + ": holds " + std::to_string(size) + " bytes, less than the " +
                     std::to_string(bytes) + " that the checkpoint goes on from");
  char last = '\n';
  if (pieces_ == Pieces::lines && bytes > 0 && ::pread(descriptor_, &last, 1, static_cast<off_t>(bytes - 1)) != 1)
    fail(errno);
  if (last != '\n')
    throw InputError(path_.string() + ": has changed: byte " + std::to_string(bytes) +
                     ", up to which the checkpoint goes on from it, ends no line");
  body_end_ = bytes;
  // Cut first: a tail amid the old pieces would spoil the file where it could not be cut.
  if (::ftruncate(descriptor_, body_end_) != 0 || !write_at(body_end_, tail_)) fail(errno);
}

void OutputFile::fail(int error_number) const {
  throw FileError(path_.string() + ": cannot write: " + std::strerror(error_number));
}

void write_whole(const std::filesystem::path& path, std::string_view text, Flush flush) {
  std::filesystem::path temporary = path;
  temporary += ".part";
  std::error_code error;
  try {
    OutputFile file(temporary);
    file.append(text);
    if (flush == Flush::now) file.sync();
    file.close();
  } catch (const FileError&) {
    std::filesystem::remove(temporary, error);
    throw;
  }
  std::filesystem::rename(temporary, path, error);
  if (error) {
    const std::string reason = error.message();
    std::filesystem::remove(temporary, error);
    throw FileError(path.string() + ": cannot write: " + reason);
  }
  if (flush == Flush::now) flush_names(folder_of(path));
}

}  // namespace nilas::output
