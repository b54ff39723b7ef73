#include "adapters/http/rules/text_template.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>
#include <utility>

namespace parlour::adapters::http {

namespace {

using Kind = TemplatePart::Kind;
using Unexpected = tl::unexpected<std::string>;

constexpr std::string_view request_id = "request.id";

bool is_name(std::string_view text) {
  const auto fits = [](unsigned char byte) {
    return std::isalnum(byte) || byte == '_' || byte == '.';
  };
  return !text.empty() && std::ranges::all_of(text, fits);
}

std::string quoted(std::string_view name) {
  return "'{" + std::string(name) + "}'";
}

// Reads one template. An error ends the reading.
// A brace whose inside is no name, as in JSON, is a text.
//
// "/v1/{place}?key=${KEY}" is the parts: text "/v1/", parameter 0, text
// "?key=", the value of KEY as a secret.
class Reader {
public:
  Reader(const TemplateNames& names, std::vector<std::string>& missing)
      : names_(names), missing_(missing) {}

  tl::expected<TextTemplate, std::string> read(std::string_view text) {
    while (!text.empty()) {
      const auto brace = text.find('{');
      const auto end =
          brace == std::string_view::npos ? brace : text.find('}', brace);
      if (end == std::string_view::npos)
        break;
      const auto inner = text.substr(brace + 1, end - brace - 1);
      if (!is_name(inner) && !inner.starts_with('/')) {
        add_text(text.substr(0, brace + 1));
        text.remove_prefix(brace + 1);
        continue;
      }
      const bool is_variable = brace > 0 && text[brace - 1] == '$';
      add_text(text.substr(0, is_variable ? brace - 1 : brace));
      text.remove_prefix(end + 1);
      if (auto wrong = is_variable ? add_variable(inner) : add_place(inner))
        return Unexpected(std::move(*wrong));
    }
    add_text(text);
    return std::move(result_);
  }

private:
  using Wrong = std::optional<std::string>;

  // Texts that follow each other become one.
  void add_text(std::string_view text) {
    if (text.empty())
      return;
    if (!result_.parts.empty() && result_.parts.back().kind == Kind::text)
      result_.parts.back().text += text;
    else
      result_.parts.push_back({Kind::text, std::string(text)});
  }

  // The value becomes a part of the template here; it is never looked up again.
  Wrong add_variable(std::string_view name) {
    if (!names_.is_request)
      return "$" + quoted(name) +
             ": a secret cannot be a part of an event, as scripts and traces "
             "would see it";
    auto value =
        names_.environment ? names_.environment(std::string(name)) : "";
    if (value.empty())
      missing_.emplace_back(name);
    result_.parts.push_back({Kind::secret, std::move(value)});
    return {};
  }

  // A command's parameter comes first: it may be called as it likes.
  Wrong add_place(std::string_view name) {
    const auto found = std::ranges::find(names_.parameters, name);
    if (found != names_.parameters.end()) {
      const auto number =
          static_cast<std::size_t>(found - names_.parameters.begin());
      result_.parts.push_back({Kind::parameter, std::string(name), number});
      return {};
    }
    if (names_.is_request && name == request_id) {
      result_.parts.push_back({Kind::request_id, {}});
      return {};
    }
    if (!names_.is_request && name.starts_with('/')) {
      result_.parts.push_back({Kind::path, {}, 0, JsonPath(name)});
      return {};
    }
    if (!names_.is_request && std::isdigit(static_cast<unsigned char>(name[0])))
      return add_group(name);
    return quoted(name) + " is not known here; there are " + known();
  }

  Wrong add_group(std::string_view name) {
    std::size_t number = 0;
    const auto* const end = name.data() + name.size();
    const auto read = std::from_chars(name.data(), end, number);
    if (read.ec != std::errc() || read.ptr != end || number > names_.groups)
      return quoted(name) + ": the expression in 'matches' has " +
             std::to_string(names_.groups) + " groups in parentheses";
    result_.parts.push_back({Kind::group, {}, number});
    return {};
  }

  // The names that may stand here, for a message.
  std::string known() const {
    std::string all;
    for (const auto& name : names_.parameters)
      all += "{" + name + "}, ";
    return all + (names_.is_request ? "{request.id} and ${VARIABLE}"
                                    : "{/path/into/the/answer} and {0}");
  }

  const TemplateNames& names_;
  std::vector<std::string>& missing_;
  TextTemplate result_;
};

} // namespace

bool TextTemplate::has(TemplatePart::Kind kind) const {
  return std::ranges::any_of(
      parts, [kind](const auto& part) { return part.kind == kind; });
}

const TemplatePart* TextTemplate::single() const {
  return parts.size() == 1 ? &parts.front() : nullptr;
}

tl::expected<TextTemplate, std::string>
read_template(std::string_view text, const TemplateNames& names,
              std::vector<std::string>& missing) {
  return Reader(names, missing).read(text);
}

// Quotes are counted over all texts of the template; a quote behind a backslash
// does not count.
void mark_quoted(TextTemplate& json) {
  bool is_in_string = false;
  for (auto& part : json.parts) {
    part.is_quoted = is_in_string;
    if (part.kind != Kind::text)
      continue;
    for (std::size_t i = 0; i < part.text.size(); ++i)
      if (part.text[i] == '"')
        is_in_string = !is_in_string;
      else if (part.text[i] == '\\' && is_in_string)
        ++i;
  }
}

} // namespace parlour::adapters::http
