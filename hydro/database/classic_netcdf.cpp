/// The classic form of NetCDF files ["NetCDF Classic Format Specification", Unidata]: a header in network byte order
/// that lists dimensions, attributes and variables, then the values of each variable at its offset.
#include <bit>
#include <cstdint>
#include <map>
#include <optional>

#include "core/base/error.h"
#include "core/base/file_bytes.h"
#include "hydro/database/labelled_file.h"

namespace nilas::hydro {

namespace {

/// Codes of the format.
enum class ListTag : std::uint32_t { absent = 0, dimension = 10, variable = 11, attribute = 12 };
enum class ValueKind : std::uint32_t { int8 = 1, text = 2, int16 = 3, int32 = 4, float32 = 5, float64 = 6, int64 = 10 };

/// Most dimensions of a variable, as the format's own library has it.
constexpr std::uint64_t k_most_dimensions = 1024;

std::optional<std::size_t> bytes_of(std::uint32_t kind) {
  switch (static_cast<ValueKind>(kind)) {
    case ValueKind::int8:
    case ValueKind::text:
      return sizeof(std::int8_t);
    case ValueKind::int16:
      return sizeof(std::int16_t);
    case ValueKind::int32:
    case ValueKind::float32:
      return sizeof(std::int32_t);
    case ValueKind::float64:
    case ValueKind::int64:
      return sizeof(std::int64_t);
  }
  return std::nullopt;
}

/// Reads the bytes from the start on.
class ByteReader {
 public:
  ByteReader(const std::string& bytes, const std::string& file) : bytes_(bytes), file_(file) {}
  [[noreturn]] void fail() const { throw InputError(file_ + ": is cut short or damaged, or no NetCDF file"); }
  void move_to(std::uint64_t place) {
    if (place > bytes_.size()) fail();
    place_ = static_cast<std::size_t>(place);
  }
  void skip(std::uint64_t count) {
    if (count > bytes_.size() - place_) fail();
    place_ += static_cast<std::size_t>(count);
  }
  std::uint64_t number(std::size_t bytes) {
    if (bytes > bytes_.size() - place_) fail();
    std::uint64_t value = 0;
    constexpr int k_bits = 8;  // of a byte
    for (std::size_t k = 0; k < bytes; ++k) value = value << k_bits | static_cast<unsigned char>(bytes_[place_++]);
    return value;
  }
  std::uint32_t tag() { return static_cast<std::uint32_t>(number(sizeof(std::uint32_t))); }
  std::string text(std::uint64_t count) {
    const std::size_t start = place_;
    skip(count);
    return bytes_.substr(start, static_cast<std::size_t>(count));
  }
  /// Entries are filled up to whole words of four bytes.
  void fill() {
    constexpr std::size_t k_word = 4;
    skip((k_word - place_ % k_word) % k_word);
  }

 private:
  const std::string& bytes_;
  std::string file_;
  std::size_t place_ = 0;
};

struct Variable {
  std::vector<std::size_t> dimensions;  ///< their places in the list of dimensions
  std::uint32_t kind = 0;
  std::uint64_t offset = 0;
};

class ClassicNetcdf : public LabelledFile {
 public:
  explicit ClassicNetcdf(const std::filesystem::path& path) : LabelledFile(path), bytes_(file_bytes(path)) {
    ByteReader in(bytes_, this->path());
    in.skip(3);
    read_version(in);
    if (in.number(length_bytes_) != 0) throw InputError(this->path() + ": has records, which are not supported");
    read_dimensions(in);
    skip_attributes(in);
    read_variables(in);
  }

  bool has(const std::string& name) const override { return variables_.count(name) > 0; }

  LabelledArray numbers(const std::string& name) const override {
    const Variable& variable = find(name);
    if (variable.kind == static_cast<std::uint32_t>(ValueKind::text)) refuse(name, "does not hold numbers");
    LabelledArray array;
    for (const std::size_t dimension : variable.dimensions) {
      array.dimensions.push_back(dimension_names_[dimension]);
      array.shape.push_back(dimension_sizes_[dimension]);
    }
    ByteReader in(bytes_, path());
    in.move_to(variable.offset);
    const std::size_t count = values_in(variable, in);
    array.values.reserve(count);
    for (std::size_t k = 0; k < count; ++k) array.values.push_back(value(in, variable.kind));
    return array;
  }

  std::vector<std::string> texts(const std::string& name) const override {
    const Variable& variable = find(name);
    if (variable.kind != static_cast<std::uint32_t>(ValueKind::text)) refuse(name, "does not hold texts");
    ByteReader in(bytes_, path());
    in.move_to(variable.offset);
    const std::size_t length = variable.dimensions.empty() ? 1 : dimension_sizes_[variable.dimensions.back()];
    const std::size_t count = length == 0 ? 0 : values_in(variable, in) / length;
    std::vector<std::string> texts;
    for (std::size_t k = 0; k < count; ++k) {
      const std::string each = in.text(length);
      texts.push_back(each.substr(0, each.find('\0')));
    }
    return texts;
  }

 private:
  void read_version(ByteReader& in) {
    constexpr std::uint64_t k_plain = 1, k_large_offsets = 2, k_large_data = 5;
    const std::uint64_t version = in.number(1);
    if (version != k_plain && version != k_large_offsets && version != k_large_data) in.fail();
    if (version == k_large_data) length_bytes_ = sizeof(std::uint64_t);
    if (version != k_plain) offset_bytes_ = sizeof(std::uint64_t);
  }

  /// The number of entries of a list of the header.
  std::uint64_t list_length(ByteReader& in, ListTag expected) const {
    const std::uint32_t tag = in.tag();
    const std::uint64_t length = in.number(length_bytes_);
    const bool empty = tag == static_cast<std::uint32_t>(ListTag::absent) && length == 0;
    if (!empty && tag != static_cast<std::uint32_t>(expected)) in.fail();
    return length;
  }

  std::string name(ByteReader& in) const {
    std::string text = in.text(in.number(length_bytes_));
    in.fill();
    return text;
  }

  void read_dimensions(ByteReader& in) {
    for (std::uint64_t n = list_length(in, ListTag::dimension); n > 0; --n) {
      dimension_names_.push_back(name(in));
      dimension_sizes_.push_back(static_cast<std::size_t>(in.number(length_bytes_)));
    }
  }

  void skip_attributes(ByteReader& in) const {
    for (std::uint64_t n = list_length(in, ListTag::attribute); n > 0; --n) {
      name(in);
      const auto bytes = bytes_of(in.tag());
      if (!bytes) in.fail();
      const std::uint64_t count = in.number(length_bytes_);
      if (count > bytes_.size()) in.fail();
      in.skip(count * *bytes);
      in.fill();
    }
  }

  void read_variables(ByteReader& in) {
    for (std::uint64_t n = list_length(in, ListTag::variable); n > 0; --n) {
      const std::string name_of_variable = name(in);
      Variable variable;
      std::uint64_t rank = in.number(length_bytes_);
      if (rank > k_most_dimensions) in.fail();
      for (; rank > 0; --rank) {
        const std::uint64_t dimension = in.number(length_bytes_);
        if (dimension >= dimension_names_.size()) in.fail();
        variable.dimensions.push_back(static_cast<std::size_t>(dimension));
      }
      skip_attributes(in);
      variable.kind = in.tag();
      if (!bytes_of(variable.kind)) in.fail();
      in.number(length_bytes_);  // bytes of the variable, which shape and kind give as well
      variable.offset = in.number(offset_bytes_);
      variables_.emplace(name_of_variable, std::move(variable));
    }
  }

  const Variable& find(const std::string& name) const {
    const auto found = variables_.find(name);
    if (found == variables_.end()) refuse(name, "is missing");
    return found->second;
  }

  /// The number of values of a variable, which the file must hold from its offset on.
  std::size_t values_in(const Variable& variable, const ByteReader& in) const {
    std::size_t count = 1;
    const std::size_t room = bytes_.size() - static_cast<std::size_t>(variable.offset);
    for (const std::size_t dimension : variable.dimensions) {
      const std::size_t n = dimension_sizes_[dimension];
      if (n > 0 && count > room / n) in.fail();
      count *= n;
    }
    if (count * *bytes_of(variable.kind) > room) in.fail();
    return count;
  }

  static double value(ByteReader& in, std::uint32_t kind) {
    const auto bytes = in.number(*bytes_of(kind));
    switch (static_cast<ValueKind>(kind)) {
      case ValueKind::int8:
      case ValueKind::text:
        return static_cast<std::int8_t>(bytes);
      case ValueKind::int16:
        return static_cast<std::int16_t>(bytes);
      case ValueKind::int32:
        return static_cast<std::int32_t>(bytes);
      case ValueKind::int64:
        return static_cast<double>(static_cast<std::int64_t>(bytes));
      case ValueKind::float32:
        return std::bit_cast<float>(static_cast<std::uint32_t>(bytes));
      case ValueKind::float64:
        return std::bit_cast<double>(bytes);
    }
    return 0;
  }

  std::string bytes_;
  std::size_t length_bytes_ = sizeof(std::uint32_t), offset_bytes_ = sizeof(std::uint32_t);
  std::vector<std::string> dimension_names_;
  std::vector<std::size_t> dimension_sizes_;
  std::map<std::string, Variable> variables_;
};

}  // namespace

std::unique_ptr<LabelledFile> open_classic(const std::filesystem::path& path) {
  return std::make_unique<ClassicNetcdf>(path);
}

}  // namespace nilas::hydro
