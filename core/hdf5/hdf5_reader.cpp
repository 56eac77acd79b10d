#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/base/error.h"
#include "core/base/file_bytes.h"
#include "core/hdf5/hdf5_answers.h"
#include "core/hdf5/reading_process.h"

namespace nilas::hdf5 {

static_assert(std::is_trivially_copyable_v<QuestionHead> && std::is_trivially_copyable_v<AnswerHead>);

using About = Question::About;
using Holds = AnswerHead::Holds;

namespace {

/// What the process that reads a file may use, by the size of the file. Its content in compressed form is bounded by
/// what is read of one dataset at most (hdf5_parser.cpp); it is held as read, as eight bytes a value, and when sent.
ReadingLimits limits_of(std::size_t file_bytes) {
  constexpr std::size_t k_base = std::size_t{128} << 20, k_share = 12;  // [bytes]
  constexpr unsigned k_seconds = 5;
  constexpr std::size_t k_bytes_a_second = 1 << 20;
  return {k_base + k_share * most_content(file_bytes),
          k_seconds + static_cast<unsigned>(file_bytes / k_bytes_a_second)};
}

std::size_t size_of(const std::filesystem::path& path) {
  std::error_code fault;
  if (std::filesystem::is_directory(path, fault)) throw FileError(path.string() + ": is a folder, not a file");
  demand_file(path);
  const std::uintmax_t size = std::filesystem::file_size(path, fault);
  if (fault) throw FileError(path.string() + ": cannot be opened: " + fault.message());
  return static_cast<std::size_t>(size);
}

/// Takes the bytes of an answer as values of a type. Memory is taken as they come, since the child may claim anything.
template <class T>
void receive_values(ReadingProcess& process, std::size_t bytes, T& values) {
  constexpr std::size_t k_step = 1 << 20, k_each = sizeof(typename T::value_type);
  if (bytes % k_each != 0) process.refuse_answer();
  const std::size_t count = bytes / k_each;
  for (std::size_t have = 0; have < count;) {
    const std::size_t next = std::min(count, std::max(2 * have, have + k_step));
    values.resize(next);
    process.receive({reinterpret_cast<char*>(values.data() + have), (next - have) * k_each});
    have = next;
  }
}

/// Asks, and takes the answer where it holds what is expected.
template <class T>
T ask(ReadingProcess& process, const std::string& path, const Question& question, Holds expected) {
  const QuestionHead asked{question.about, question.name.size(), question.rows.count, question.rows.columns};
  process.send({reinterpret_cast<const char*>(&asked), sizeof asked});
  process.send(question.name);
  AnswerHead head;
  process.receive({reinterpret_cast<char*>(&head), sizeof head});
  T values;
  if (head.holds == expected) {
    receive_values(process, head.bytes, values);
    return values;
  }
  constexpr std::size_t k_longest_fault = 1 << 20;
  if (head.bytes > k_longest_fault) process.refuse_answer();
  std::string fault;
  receive_values(process, head.bytes, fault);
  if (head.holds == Holds::input_fault) throw InputError(fault);
  if (head.holds == Holds::file_fault) throw FileError(fault);
  if (head.holds != Holds::out_of_memory) process.refuse_answer();
  throw FileError(path + ": cannot be read: this takes more memory than there is, or than a file of its size may need");
}

}  // namespace

Hdf5Reader::Hdf5Reader(const std::filesystem::path& path, Place place) : path_(path.string()) {
  process_ = std::make_unique<ReadingProcess>(path_, limits_of(size_of(path)),
                                              [&](int socket) { answer_questions(socket, path, place); });
  ask_integers({About::opening, {}, {}});
}

Hdf5Reader::~Hdf5Reader() = default;

std::vector<double> Hdf5Reader::ask_numbers(const Question& question) const {
  return ask<std::vector<double>>(*process_, path_, question, Holds::numbers);
}

std::vector<std::int64_t> Hdf5Reader::ask_integers(const Question& question) const {
  return ask<std::vector<std::int64_t>>(*process_, path_, question, Holds::integers);
}

std::int64_t Hdf5Reader::ask_integer(const Question& question) const {
  const auto answer = ask_integers(question);
  if (answer.size() != 1) process_->refuse_answer();
  return answer.front();
}

std::vector<std::string> Hdf5Reader::ask_texts(const Question& question) const {
  const auto all = ask<std::string>(*process_, path_, question, Holds::texts);
  std::vector<std::string> texts;
  for (std::size_t at = 0; at < all.size();) {
    std::uint64_t length = 0;
    if (all.size() - at < sizeof length) process_->refuse_answer();
    std::memcpy(&length, all.data() + at, sizeof length);
    at += sizeof length;
    if (length > all.size() - at) process_->refuse_answer();
    texts.push_back(all.substr(at, length));
    at += length;
  }
  return texts;
}

void Hdf5Reader::refuse(const std::string& name, const std::string& fault) const {
  throw InputError(path_ + ": /" + name + ": " + fault);
}

bool Hdf5Reader::has(const std::string& name) const { return ask_integer({About::has, name, {}}) != 0; }

bool Hdf5Reader::is_filled(const std::string& name) const { return ask_integer({About::is_filled, name, {}}) != 0; }

std::size_t Hdf5Reader::size(const std::string& name) const {
  return static_cast<std::size_t>(ask_integer({About::size, name, {}}));
}

Hdf5Reader::Kind Hdf5Reader::kind(const std::string& name) const {
  switch (ask_integer({About::kind, name, {}})) {
    case static_cast<std::int64_t>(Kind::numbers):
      return Kind::numbers;
    case static_cast<std::int64_t>(Kind::integers):
      return Kind::integers;
    case static_cast<std::int64_t>(Kind::text):
      return Kind::text;
    default:
      return Kind::other;
  }
}

std::vector<std::size_t> Hdf5Reader::shape(const std::string& name) const {
  const auto shape = ask_integers({About::shape, name, {}});
  return {shape.begin(), shape.end()};
}

std::string Hdf5Reader::text(const std::string& name) const {
  const auto one = ask_texts({About::text, name, {}});
  return one.empty() ? std::string() : one.front();
}

std::vector<std::string> Hdf5Reader::texts(const std::string& name) const {
  return ask_texts({About::texts, name, {}});
}

std::vector<std::string> Hdf5Reader::dimension_names(const std::string& name) const {
  return ask_texts({About::dimension_names, name, {}});
}

std::vector<std::string> Hdf5Reader::datasets(const std::string& group) const {
  return ask_texts({About::datasets, group, {}});
}

std::vector<std::int64_t> Hdf5Reader::wide_integers(const std::string& name) const {
  return ask_integers({About::integers, name, {}});
}

std::vector<double> Hdf5Reader::exact_numbers(const std::string& name) const {
  return ask_numbers({About::numbers, name, {}});
}

std::vector<double> Hdf5Reader::first_numbers(const std::string& name, std::size_t count) const {
  auto values = ask_numbers({About::first_numbers, name, {count}});
  if (values.size() != count) process_->refuse_answer();
  return values;
}

std::vector<std::int64_t> Hdf5Reader::first_integers(const std::string& name, std::size_t count) const {
  return first_integers(name, count, 1);
}

std::vector<std::int64_t> Hdf5Reader::first_integers(const std::string& name, std::size_t count,
                                                     std::size_t columns) const {
  auto values = ask_integers({About::first_integers, name, {count, columns}});
  if (values.size() != count * columns) process_->refuse_answer();
  return values;
}

std::vector<int> Hdf5Reader::integers(const std::string& name) const {
  std::vector<int> values;
  for (const std::int64_t x : wide_integers(name)) {
    if (x < std::numeric_limits<int>::min() || x > std::numeric_limits<int>::max())
      refuse(name, "holds " + std::to_string(x) + ", beyond 32 bits");
    values.push_back(static_cast<int>(x));
  }
  return values;
}

int Hdf5Reader::integer(const std::string& name) const {
  const auto values = integers(name);
  if (values.size() != 1) refuse(name, "has " + std::to_string(values.size()) + " entries, needs 1");
  return values.front();
}

static VecX vector_of(const std::vector<double>& values) {
  return Eigen::Map<const VecX>(values.data(), static_cast<Eigen::Index>(values.size()));
}

VecX Hdf5Reader::numbers(const std::string& name) const {
  const auto values = exact_numbers(name);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isfinite(values[i])) refuse(name, "entry " + std::to_string(i) + " is not finite");
  return vector_of(values);
}

VecX Hdf5Reader::numbers_or_infinity(const std::string& name) const {
  const auto values = exact_numbers(name);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::isnan(values[i])) refuse(name, "entry " + std::to_string(i) + " is not a number");
  return vector_of(values);
}

}  // namespace nilas::hdf5
