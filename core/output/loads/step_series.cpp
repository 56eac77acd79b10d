#include "core/output/loads/step_series.h"

#include <algorithm>
#include <span>
#include <string_view>

#include "core/base/error.h"

namespace nilas::output {

StepSeries::StepSeries(std::size_t columns, const std::filesystem::path& file, std::optional<std::int64_t> keep)
    : columns_(columns), file_(std::make_unique<OutputFile>(file, "", keep, Pieces::bytes)) {
  NILAS_DEMAND(columns > 0);
}

void StepSeries::append(const std::vector<double>& row) {
  NILAS_DEMAND(row.size() == columns_);
  rest_.insert(rest_.end(), row.begin(), row.end());
  ++rows_;
  if (file_ && rest_.size() == k_block * columns_) write_block();
}

void StepSeries::write_block() {
  std::vector<double> block(rest_.size());
  for (std::size_t r = 0; r < k_block; ++r)
    for (std::size_t c = 0; c < columns_; ++c) block[c * k_block + r] = rest_[r * columns_ + c];
  file_->append({reinterpret_cast<const char*>(block.data()), sizeof(double) * block.size()});
  for (const double x : block) hash_.add(x);
  ++blocks_;
  rest_.clear();
}

std::vector<double> StepSeries::column(std::size_t column, std::size_t first, std::size_t last) const {
  last = std::min(last, rows_);
  std::vector<double> values(last - std::min(first, last));
  const std::size_t in_file = k_block * blocks_;
  std::size_t row = first;
  while (row < std::min(last, in_file)) {
    const std::size_t block = row / k_block, end = std::min(last, (block + 1) * k_block);
    const std::size_t place = (block * columns_ + column) * k_block + row % k_block;
    file_->read(static_cast<std::int64_t>(sizeof(double) * place),
                std::as_writable_bytes(std::span(values).subspan(row - first, end - row)));
    row = end;
  }
  for (; row < last; ++row) values[row - first] = rest_[(row - in_file) * columns_ + column];
  return values;
}

void StepSeries::save(StateWriter out) const {
  out.add("rest", rest_);
  out.add("checksum", static_cast<std::int64_t>(hash_.value()));
}

void StepSeries::restore(const StateReader& in, std::size_t rows) {
  rows_ = rows;
  hash_ = {};
  blocks_ = file_ ? rows / k_block : 0;
  const std::size_t bytes = sizeof(double) * k_block * columns_;
  in.get("rest", rest_, columns_ * (rows - k_block * blocks_));
  std::int64_t checksum = 0;
  in.get("checksum", checksum);
  if (!file_) return;
  std::vector<double> block(k_block * columns_);
  const bool whole = file_->bytes() == static_cast<std::int64_t>(bytes * blocks_);
  for (std::size_t b = 0; whole && b < blocks_; ++b) {
    file_->read(static_cast<std::int64_t>(bytes * b), std::as_writable_bytes(std::span(block)));
    for (const double x : block) hash_.add(x);
  }
  if (!whole || static_cast<std::int64_t>(hash_.value()) != checksum)
    throw InputError(file_->path().string() +
                     ": has changed since the checkpoint was written, or is damaged: its checksum is not the one that "
                     "the checkpoint holds. The run cannot go on without it, and must begin again.");
}

}  // namespace nilas::output
