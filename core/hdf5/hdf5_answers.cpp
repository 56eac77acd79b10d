#include "core/hdf5/hdf5_answers.h"

#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <new>
#include <optional>
#include <span>
#include <variant>

#include "core/base/error.h"
#include "core/hdf5/first_reason.h"
#include "core/hdf5/reading_process.h"

namespace nilas::hdf5 {

std::string joined(const std::vector<std::string>& texts) {
  std::string all;
  for (const auto& text : texts) {
    const std::uint64_t length = text.size();
    all.append(reinterpret_cast<const char*>(&length), sizeof length).append(text);
  }
  return all;
}

namespace {

using Answer = std::variant<std::vector<double>, std::vector<std::int64_t>, std::vector<std::string>>;
using Integers = std::vector<std::int64_t>;
using Texts = std::vector<std::string>;
using Holds = AnswerHead::Holds;

Answer answer_of(const Hdf5Parser& file, const Question& question) {
  using About = Question::About;
  const std::string& name = question.name;
  switch (question.about) {
    case About::opening:
      return Integers{};
    case About::has:
      return Integers{file.has(name)};
    case About::is_filled:
      return Integers{file.is_filled(name)};
    case About::kind:
      return Integers{static_cast<std::int64_t>(file.kind(name))};
    case About::size:
      return Integers{static_cast<std::int64_t>(file.size(name))};
    case About::shape: {
      const auto shape = file.shape(name);
      return Integers(shape.begin(), shape.end());
    }
    case About::text:
      return Texts{file.text(name)};
    case About::texts:
      return file.texts(name);
    case About::dimension_names:
      return file.dimension_names(name);
    case About::datasets:
      return file.datasets(name);
    case About::numbers:
      return file.numbers(name);
    case About::integers:
      return file.integers(name);
    case About::first_numbers:
      return file.first_numbers(name, question.rows);
    case About::first_integers:
      return file.first_integers(name, question.rows);
  }
  return Integers{};
}

bool send_answer(int socket, Holds holds, std::span<const char> bytes) {
  const AnswerHead head{holds, bytes.size()};
  return send_bytes(socket, {reinterpret_cast<const char*>(&head), sizeof head}) && send_bytes(socket, bytes);
}

template <class T>
std::span<const char> bytes_of(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

bool send_answer(int socket, const Answer& answer) {
  if (const auto* numbers = std::get_if<std::vector<double>>(&answer))
    return send_answer(socket, Holds::numbers, bytes_of(*numbers));
  if (const auto* integers = std::get_if<Integers>(&answer))
    return send_answer(socket, Holds::integers, bytes_of(*integers));
  return send_answer(socket, Holds::texts, joined(std::get<Texts>(answer)));
}

bool receive_bytes(int socket, std::span<char> bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::recv(socket, bytes.data(), bytes.size(), 0);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
  return true;
}

std::optional<Question> next_question(int socket) {
  QuestionHead head;
  if (!receive_bytes(socket, {reinterpret_cast<char*>(&head), sizeof head})) return {};
  Question question{head.about, std::string(head.name_bytes, '\0'), {head.rows, head.columns}};
  if (!receive_bytes(socket, question.name)) return {};
  return question;
}

}  // namespace

void answer_questions(int socket, const std::filesystem::path& path, Hdf5Reader::Place place) {
  const Hdf5Silence silence;
  std::optional<Hdf5Parser> file;
  while (const auto question = next_question(socket)) {
    const FirstReason reason;
    bool heard = false;
    try {
      if (!file) file.emplace(path, place == Hdf5Reader::Place::disk);
      heard = send_answer(socket, answer_of(*file, *question));
    } catch (const InputError& fault) {
      const std::string of_system = path.string() + ": cannot be read: " + reason.text();
      heard = reason.of_system() ? send_answer(socket, Holds::file_fault, of_system)
                                 : send_answer(socket, Holds::input_fault, std::string(fault.what()));
    } catch (const FileError& fault) {
      heard = send_answer(socket, Holds::file_fault, std::string(fault.what()));
    } catch (const std::bad_alloc&) {
      heard = send_answer(socket, Holds::out_of_memory, {});
    }
    if (!heard) break;
  }
  // HDF5 would close what a damaged file left open, and may crash at that: the process ends without it.
  ::_exit(0);
}

}  // namespace nilas::hdf5
