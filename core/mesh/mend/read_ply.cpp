/// Polygon file format: a text header that names elements and their properties, then text or binary data.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <optional>

#include "core/base/error.h"
#include "core/geometry/mesh_words.h"
#include "core/mesh/mend/soup_formats.h"

namespace nilas::mesh {

namespace {

static_assert(std::endian::native == std::endian::little, "binary values are turned from big-endian only");

enum class Number { i8, u8, i16, u16, i32, u32, f32, f64 };

struct Property {
  std::string name;
  Number type = Number::f32;
  std::optional<Number> length;  ///< only for a list: type of its length
};

struct Element {
  std::string name;
  long long count = 0;
  std::vector<Property> properties;
};

struct Header {
  bool text = false, swapped = false;
  std::vector<Element> elements;
};

Number number_type(const geometry::MeshWords& words, std::string_view word) {
  static const std::map<std::string_view, Number> types{
      {"char", Number::i8},   {"int8", Number::i8},     {"uchar", Number::u8},   {"uint8", Number::u8},
      {"short", Number::i16}, {"int16", Number::i16},   {"ushort", Number::u16}, {"uint16", Number::u16},
      {"int", Number::i32},   {"int32", Number::i32},   {"uint", Number::u32},   {"uint32", Number::u32},
      {"float", Number::f32}, {"float32", Number::f32}, {"double", Number::f64}, {"float64", Number::f64}};
  const auto found = types.find(word);
  if (found == types.end()) words.fail("a type of number (char, uchar, short, ushort, int, uint, float, double)", word);
  return found->second;
}

Property read_property(geometry::MeshWords& words) {
  Property p;
  auto word = words.next_on_line();
  if (word == "list") {
    p.length = number_type(words, words.next_on_line());
    word = words.next_on_line();
  }
  p.type = number_type(words, word);
  p.name = words.next_on_line();
  return p;
}

void read_format(geometry::MeshWords& words, Header& header) {
  const auto word = words.next_on_line();
  header.text = word == "ascii";
  header.swapped = word == "binary_big_endian";
  if (!header.text && !header.swapped && word != "binary_little_endian")
    words.fail("ascii, binary_little_endian or binary_big_endian", word);
}

void demand_places(const Header& header, const geometry::MeshWords& words) {
  for (const char* axis : {"x", "y", "z"}) {
    const auto names_axis = [&](const Property& p) { return p.name == axis && !p.length; };
    const auto gives_axis = [&](const Element& e) {
      return e.name == "vertex" && std::any_of(e.properties.begin(), e.properties.end(), names_axis);
    };
    if (std::none_of(header.elements.begin(), header.elements.end(), gives_axis))
      words.fail(std::string("an element vertex with the property ") + axis, "none before end_header");
  }
}

Header read_header(const std::string& text, const std::string& file) {
  Header header;
  geometry::MeshWords words(text, file);
  if (const auto magic = words.next(); magic != "ply") words.fail("ply", magic);
  bool has_format = false;
  for (auto word = words.next(); !word.empty(); word = words.next()) {
    if (word == "format") {
      read_format(words, header);
      has_format = true;
    } else if (word == "element") {
      Element e{std::string(words.next_on_line()), words.integer(words.next_on_line()), {}};
      if (e.count < 0) words.fail("a count of at least 0", std::to_string(e.count));
      header.elements.push_back(e);
    } else if (word == "property" && !header.elements.empty()) {
      header.elements.back().properties.push_back(read_property(words));
    } else if (word != "comment" && word != "obj_info") {
      words.fail("format, element, property, comment or end_header", word);
    }
    words.skip_line();
  }
  if (!has_format) words.fail("format", "none before end_header");
  demand_places(header, words);
  return header;
}

/// Data as text.
class TextData {
 public:
  TextData(std::string_view text, const std::string& file, int first_line)
      : words_(text, file, {.first_line = first_line}) {}
  void enter(const Element&, long long) {}
  double value(Number) {
    word_ = words_.next();
    return words_.number(word_);
  }
  [[noreturn]] void fail(const std::string& what) const { words_.fail(what, word_); }

 private:
  geometry::MeshWords words_;
  std::string_view word_;
};

/// Data in binary form.
class BinaryData {
 public:
  BinaryData(std::string_view bytes, std::size_t start, bool swapped, const std::string& file)
      : bytes_(bytes), start_(start), swapped_(swapped), file_(file) {}

  /// The item that is read next, named in faults.
  void enter(const Element& element, long long number) {
    element_ = &element;
    number_ = number;
  }

  double value(Number type) {
    switch (type) {
      case Number::i8:
        return take<std::int8_t>();
      case Number::u8:
        return take<std::uint8_t>();
      case Number::i16:
        return take<std::int16_t>();
      case Number::u16:
        return take<std::uint16_t>();
      case Number::i32:
        return take<std::int32_t>();
      case Number::u32:
        return take<std::uint32_t>();
      case Number::f32:
        return static_cast<double>(take<float>());
      case Number::f64:
        break;
    }
    return take<double>();
  }
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(file_ + ": " + element_->name + " " + std::to_string(number_) + " (from 0), byte " +
                     std::to_string(start_ + place_) + ": expected " + what);
  }

 private:
  template <class T>
  T take() {
    std::array<char, sizeof(T)> raw{};
    if (bytes_.size() - place_ < raw.size()) fail("more data, found the end of the file: it is cut short");
    std::memcpy(raw.data(), bytes_.data() + place_, raw.size());
    if (swapped_) std::reverse(raw.begin(), raw.end());
    place_ += raw.size();
    return std::bit_cast<T>(raw);
  }

  std::string_view bytes_;
  std::size_t start_;  ///< bytes of the header
  bool swapped_;
  const std::string& file_;
  std::size_t place_ = 0;
  const Element* element_ = nullptr;
  long long number_ = 0;
};

template <class Data>
double coordinate(Data& data, Number type) {
  const double x = data.value(type);
  if (!std::isfinite(x)) data.fail("a finite coordinate");
  return x;
}

template <class Data>
long long whole(Data& data, Number type, long long least, const std::string& what) {
  const double x = data.value(type);
  constexpr double k_most = 2147483647;
  if (!(x >= static_cast<double>(least) && x <= k_most) || x != std::floor(x)) data.fail(what);
  return static_cast<long long>(x);
}

template <class Data>
void read_vertex(Data& data, const Element& element, PolygonSoup& soup) {
  Vec3 p = Vec3::Zero();
  for (const auto& property : element.properties) {
    const int axis = property.name == "x" ? 0 : property.name == "y" ? 1 : property.name == "z" ? 2 : -1;
    const long long n = property.length ? whole(data, *property.length, 0, "the length of a list") : 1;
    for (long long k = 0; k < n; ++k)
      if (axis >= 0)
        p[axis] = coordinate(data, property.type);
      else
        data.value(property.type);
  }
  soup.points.push_back(p);
}

template <class Data>
void read_other(Data& data, const Element& element, PolygonSoup& soup) {
  for (const auto& property : element.properties) {
    const bool loop = element.name == "face" && property.length &&
                      (property.name == "vertex_indices" || property.name == "vertex_index");
    const long long n = property.length ? whole(data, *property.length, loop ? 3 : 0,
                                                loop ? "at least three corners of a face" : "the length of a list")
                                        : 1;
    std::vector<int> corners;
    for (long long k = 0; k < n; ++k) {
      if (!loop) {
        data.value(property.type);
        continue;
      }
      const long long index = whole(data, property.type, 0, "the number of a vertex");
      if (index >= static_cast<long long>(soup.points.size()))
        data.fail("the number of a vertex below " + std::to_string(soup.points.size()));
      corners.push_back(static_cast<int>(index));
    }
    if (loop) soup.polygons.push_back(std::move(corners));
  }
}

template <class Data>
PolygonSoup read_data(Data data, const Header& header) {
  PolygonSoup soup;
  for (const auto& element : header.elements)
    // an element without properties takes no bytes, however many the header promises
    for (long long k = 0; k < element.count && !element.properties.empty(); ++k) {
      data.enter(element, k);
      element.name == "vertex" ? read_vertex(data, element, soup) : read_other(data, element, soup);
    }
  return soup;
}

/// Where the line end_header begins: comments may hold the word.
std::size_t end_of_header(const std::string& bytes) {
  constexpr std::string_view k_line = "\nend_header";
  std::size_t at = bytes.find(k_line);
  while (at != std::string::npos && at + k_line.size() < bytes.size() &&
         std::string_view(" \t\r\n").find(bytes[at + k_line.size()]) == std::string_view::npos)
    at = bytes.find(k_line, at + 1);
  return at == std::string::npos ? at : at + 1;
}

}  // namespace

PolygonSoup parse_ply(const std::string& bytes, const std::string& file) {
  const std::size_t end = end_of_header(bytes);
  if (end == std::string::npos) throw InputError(file + ": not a PLY file, or cut short: it has no end_header");
  const std::size_t line_end = bytes.find('\n', end);
  const std::size_t start = line_end == std::string::npos ? bytes.size() : line_end + 1;
  const Header header = read_header(bytes.substr(0, end), file);
  const std::string_view data = std::string_view(bytes).substr(start);
  if (header.text) {
    const auto lines = std::count(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(start), '\n');
    return read_data(TextData(data, file, static_cast<int>(lines) + 1), header);
  }
  return read_data(BinaryData(data, start, header.swapped, file), header);
}

}  // namespace nilas::mesh
