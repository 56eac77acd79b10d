#pragma once
/// What Hdf5Reader and the process that reads its file say to each other: a question, then its answer.
#include <cstdint>
#include <filesystem>
#include <string>

#include "core/hdf5/hdf5_parser.h"

namespace nilas::hdf5 {

struct Question {
  enum class About : std::uint64_t {
    opening,
    has,
    is_filled,
    kind,
    size,
    shape,
    text,
    texts,
    dimension_names,
    datasets,
    numbers,
    integers,
    first_numbers,
    first_integers
  };
  About about = About::opening;
  std::string name;  ///< of a dataset or a group
  Rows rows;         ///< of the first numbers and integers
};

/// What goes before the bytes of a question and of an answer.
struct QuestionHead {
  Question::About about = Question::About::opening;
  std::uint64_t name_bytes = 0, rows = 0, columns = 0;
};
struct AnswerHead {
  enum class Holds : std::uint64_t { numbers, integers, texts, input_fault, file_fault, out_of_memory };
  Holds holds = Holds::integers;
  std::uint64_t bytes = 0;
};

/// Answers questions about a file until nobody asks any more. Then it ends the process.
[[noreturn]] void answer_questions(int socket, const std::filesystem::path& path, Hdf5Reader::Place place);

/// Texts as one: each after its length in eight bytes.
std::string joined(const std::vector<std::string>& texts);

}  // namespace nilas::hdf5
