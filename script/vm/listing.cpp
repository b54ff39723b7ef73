// A listing looks like this:
//
//   function double: 1 of 1 parameters needed, 3 registers
//     app/main.xml:4
//       0  multiply_constant            r1 = r0 * 2
//       1  give_back                    end with r1

#include "script/vm/listing.hpp"

#include <array>
#include <cctype>
#include <cstdint>

#include <fmt/format.h>

#include "script/expression/builtins.hpp"
#include "script/program/effect_names.hpp"
#include "script/program/instruction.hpp"
#include "script/values/operations.hpp"

namespace parlour::script {

namespace {

constexpr std::array sentences{
#define INSTRUCTION(name, sentence) std::string_view(sentence),
#include "script/program/instructions.def"
#undef INSTRUCTION
};

constexpr std::size_t max_text = 40;

bool is_letter(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

// Formats one instruction by its sentence: operands, constants and distances
// are replaced by what they stand for. The sentence is read from left to right;
// what an operand means follows from the words before and behind it.
class Line {
public:
  Line(const Program& program, const Code& code, std::size_t at)
      : program_(program), code_(code), at_(at),
        instruction_(code.instructions[at]),
        sentence_(sentences[instruction_.operation]) {}

  std::string text() {
    while (place_ < sentence_.size())
      take();
    return std::move(text_);
  }

private:
  // The longest patterns come first: "by `wide`" is a target, "`wide`" alone is
  // not.
  void take() {
    if (skip("by `wide`"))
      text_ += target(text_.ends_with("back ") ? -distance() : distance());
    else if (skip("`wide`"))
      text_ += wide();
    else if (skip("by c"))
      text_ += target(static_cast<std::int16_t>(instruction_.c));
    else if (skip("K["))
      take_constant();
    else if (is_letter(sentence_[place_]))
      take_word();
    else
      text_ += sentence_[place_++];
  }

  bool skip(std::string_view expected) {
    if (!sentence_.substr(place_).starts_with(expected))
      return false;
    place_ += expected.size();
    return true;
  }

  // Strings are quoted and cut, so that each instruction fits into a line.
  void take_constant() {
    const auto index = operand(sentence_[place_]);
    place_ += 2; // and the bracket
    std::string shown;
    const auto& constant = code_.constants[index];
    const bool fits = print(shown, constant, max_text);
    text_ += constant.is_string() ? '"' + shown + (fits ? "\"" : "…\"") : shown;
  }

  // A single letter a, b or c is an operand; any other word is copied.
  void take_word() {
    const auto begin = place_;
    while (place_ < sentence_.size() && is_letter(sentence_[place_]))
      ++place_;
    const auto word = sentence_.substr(begin, place_ - begin);
    if (word == "flag")
      text_ += text_.ends_with("is ") ? (instruction_.flag ? "true" : "false")
                                      : std::to_string(instruction_.flag);
    else if (word.size() == 1 && word[0] >= 'a' && word[0] <= 'c')
      text_ += named(operand(word[0]));
    else
      text_ += word;
  }

  std::uint16_t operand(char letter) const {
    return letter == 'a'   ? instruction_.a
           : letter == 'b' ? instruction_.b
                           : instruction_.c;
  }

  // An operand by the kind of thing it is an index of; mostly a register.
  std::string named(std::uint16_t index) const {
    if (text_.ends_with("session variable "))
      return program_.variables[index].name;
    if (text_.ends_with("built-in "))
      return builtin(index).name;
    if (text_.ends_with("shape "))
      return "<" +
             element_of(static_cast<EffectKind>(code_.effects[index].kind)) +
             ">";
    const auto rest = sentence_.substr(place_);
    if (rest.starts_with(" registers") || rest.starts_with(" pairs"))
      return std::to_string(index);
    for (const auto* what :
         {"system variable ", "parameter ", "table ", "list of "})
      if (text_.ends_with(what))
        return std::to_string(index);
    return "r" + std::to_string(index);
  }

  // Of a call the function's name; otherwise a number.
  std::string wide() const {
    return text_.ends_with("code ")
               ? "'" + program_.code[instruction_.wide()].name + "'"
               : std::to_string(instruction_.wide());
  }

  std::int64_t distance() const {
    return instruction_.distance();
  }

  // Distances count from the jump itself.
  std::string target(std::int64_t distance) const {
    return "to " + std::to_string(static_cast<std::int64_t>(at_) + distance);
  }

  const Program& program_;
  const Code& code_;
  std::size_t at_;
  const Instruction& instruction_;
  std::string_view sentence_;
  std::size_t place_ = 0;
  std::string text_;
};

} // namespace

std::string listing(const Program& program, const Code& code) {
  auto text = fmt::format("{}: {} of {} parameters needed, {} registers\n",
                          code.name, code.required_count, code.parameter_count,
                          code.register_count);
  std::string place;
  for (std::size_t at = 0; at < code.instructions.size(); ++at) {
    const auto now = program.place(code.positions[at]);
    const auto here = fmt::format("{}:{}", now.file, now.line);
    if (here != place)
      text += "  " + here + "\n";
    place = here;
    const auto operation =
        static_cast<Operation>(code.instructions[at].operation);
    text += fmt::format("{:>5}  {:<28} {}\n", at, name_of(operation),
                        Line(program, code, at).text());
  }
  return text;
}

std::string listing(const Program& program) {
  std::string text;
  for (const auto& code : program.code)
    text += listing(program, code) + '\n';
  return text;
}

} // namespace parlour::script
