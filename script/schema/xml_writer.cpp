#include "script/schema/xml_writer.hpp"

namespace parlour::script {

// Enough for texts and for values in double quotes.
void XmlWriter::escaped(std::string_view content) {
  for (const char letter : content)
    if (letter == '&')
      text_ += "&amp;";
    else if (letter == '<')
      text_ += "&lt;";
    else if (letter == '"')
      text_ += "&quot;";
    else
      text_ += letter;
}

void XmlWriter::start(std::string_view name, Attributes attributes,
                      std::string_view end) {
  indent();
  text_.append("<").append(name);
  for (const auto& [attribute, value] : attributes) {
    text_.append(" ").append(attribute).append("=\"");
    escaped(value);
    text_ += '"';
  }
  text_.append(end);
}

void XmlWriter::text(std::string_view name, std::string_view content,
                     Attributes attributes) {
  start(name, attributes, ">");
  escaped(content);
  text_.append("</").append(name).append(">\n");
}

} // namespace parlour::script
