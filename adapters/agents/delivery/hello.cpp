#include "adapters/agents/delivery/hello.hpp"

#include <algorithm>
#include <charconv>
#include <functional>
#include <map>
#include <random>

#include <fmt/format.h>

namespace parlour::adapters::agents {
namespace {

// The parameters "key=value" of a hello or welcome. Of a key that occurs twice
// the last value counts. Refers to the message.
class Pairs {
public:
  explicit Pairs(const AgentMessage& message) {
    for (const std::string_view pair : message.parameters)
      if (const auto equals = pair.find('='); equals != pair.npos)
        values_[pair.substr(0, equals)] = pair.substr(equals + 1);
  }

  std::string text(std::string_view key) const {
    const auto found = values_.find(key);
    return found == values_.end() ? std::string() : std::string(found->second);
  }

  // Leaves `number` unchanged if there is no such key.
  Read<void> number(std::string_view key, std::uint64_t& number) const {
    const auto found = values_.find(key);
    return found == values_.end() ? Read<void>()
                                  : read_number(key, found->second, number);
  }

  static Read<void> read_number(std::string_view key, std::string_view text,
                                std::uint64_t& number) {
    const auto* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    if (text.empty() || error != std::errc() || stop != end)
      return malformed(
          fmt::format("{} is a number, not '{}'", key, excerpt(text, 32)));
    return {};
  }

private:
  std::map<std::string_view, std::string_view> values_;
};

bool is_incarnation(std::string_view text) {
  return text.size() <= 32 && std::ranges::all_of(text, [](char c) {
           return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') ||
                  (c >= 'A' && c <= 'F');
         });
}

// "seen" is INCARNATION:NUMBER.
Read<Introduction> introduction_of(const Pairs& pairs) {
  Introduction introduction;
  introduction.incarnation = pairs.text("incarnation");
  if (!is_incarnation(introduction.incarnation))
    return malformed("incarnation consists of at most 32 hexadecimal digits");
  if (auto read = pairs.number("window", introduction.window); !read)
    return tl::make_unexpected(std::move(read.error()));
  introduction.packed = pairs.text("packed") == "1";
  const auto seen = pairs.text("seen");
  if (seen.empty())
    return introduction;
  const auto colon = std::min(seen.find(':'), seen.size());
  introduction.seen_incarnation = seen.substr(0, colon);
  if (auto read = Pairs::read_number(
          "seen",
          std::string_view(seen).substr(std::min(colon + 1, seen.size())),
          introduction.seen_number);
      !read)
    return tl::make_unexpected(std::move(read.error()));
  return introduction;
}

// The names of roles, which blanks separate.
std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words;
  while (!text.empty()) {
    const auto end = std::min(text.find(' '), text.size());
    if (end > 0)
      words.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return words;
}

// Both a hello and a welcome introduce their sender.
void add(AgentMessage& message, const Introduction& introduction) {
  auto& parameters = message.parameters;
  if (!introduction.incarnation.empty())
    parameters.push_back("incarnation=" + introduction.incarnation);
  if (!introduction.seen_incarnation.empty())
    parameters.push_back(fmt::format(
        "seen={}:{}", introduction.seen_incarnation, introduction.seen_number));
  parameters.push_back(fmt::format("window={}", introduction.window));
  if (introduction.packed)
    parameters.emplace_back("packed=1");
}

} // namespace

AgentMessage hello_message(const Hello& hello) {
  AgentMessage message;
  message.kind = MessageKind::hello;
  message.component = hello.name;
  message.command = "Hello";
  message.parameters = {fmt::format("version={}", hello.version),
                        fmt::format("oldest={}", hello.oldest)};
  add(message, hello.introduction);
  if (!hello.roles.empty())
    message.parameters.push_back(
        fmt::format("roles={}", fmt::join(hello.roles, " ")));
  if (hello.json)
    message.parameters.emplace_back("json=1");
  if (!hello.token.empty())
    message.parameters.push_back("token=" + hello.token);
  return message;
}

Read<Hello> hello_of(const AgentMessage& message) {
  const Pairs pairs(message);
  Hello hello;
  hello.name = message.component;
  // An agent that gives no "version" speaks version 1. One that gives no
  // "oldest" speaks only its newest version.
  hello.version = hello.oldest = 1;
  if (auto read = pairs.number("version", hello.version); !read)
    return tl::make_unexpected(std::move(read.error()));
  hello.oldest = hello.version;
  if (auto read = pairs.number("oldest", hello.oldest); !read)
    return tl::make_unexpected(std::move(read.error()));
  auto introduction = introduction_of(pairs);
  if (!introduction)
    return tl::make_unexpected(std::move(introduction.error()));
  hello.introduction = std::move(*introduction);
  hello.roles = words_of(pairs.text("roles"));
  hello.json = pairs.text("json") == "1";
  hello.token = pairs.text("token");
  return hello;
}

Read<std::uint64_t> common_version(const Hello& hello, Versions own) {
  const auto version = std::min(hello.version, own.newest);
  if (version < std::max(hello.oldest, own.oldest))
    return tl::make_unexpected(WireError{
        WireErrorKind::version,
        fmt::format("versions {} to {} are spoken here, not {} to {}",
                    own.oldest, own.newest, hello.oldest, hello.version)});
  return version;
}

Read<void> check_version(const Welcome& welcome, const Hello& hello) {
  if (welcome.version < hello.oldest || welcome.version > hello.version)
    return tl::make_unexpected(WireError{
        WireErrorKind::version,
        fmt::format("the agent speaks versions {} to {}, and the platform "
                    "welcomes it in version {}",
                    hello.oldest, hello.version, welcome.version)});
  return {};
}

AgentMessage welcome_message(const Introduction& introduction,
                             std::uint64_t version) {
  AgentMessage message;
  message.kind = MessageKind::welcome;
  message.component = "Parlour";
  message.command = "Welcome";
  message.parameters = {fmt::format("version={}", version)};
  add(message, introduction);
  return message;
}

Read<Welcome> welcome_of(const AgentMessage& message) {
  const Pairs pairs(message);
  Welcome welcome;
  welcome.version = 1; // where it does not say
  if (auto read = pairs.number("version", welcome.version); !read)
    return tl::make_unexpected(std::move(read.error()));
  auto introduction = introduction_of(pairs);
  if (!introduction)
    return tl::make_unexpected(std::move(introduction.error()));
  welcome.introduction = std::move(*introduction);
  return welcome;
}

AgentMessage error_message(const WireError& error) {
  AgentMessage message;
  message.kind = MessageKind::error;
  message.component = "Parlour";
  message.command = name_of(error.kind);
  message.parameters = {error.sentence};
  return message;
}

std::string new_incarnation() {
  std::random_device device;
  return fmt::format("{:08x}{:08x}", device(), device());
}

} // namespace parlour::adapters::agents
