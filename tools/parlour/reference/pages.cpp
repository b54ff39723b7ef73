// Each page is an introduction and the sections of its entries; the index links
// to all of them.
#include "tools/parlour/reference/pages.hpp"

#include <algorithm>
#include <cctype>

#include "tools/parlour/reference/element_entry.hpp"
#include "tools/parlour/reference/entry_page.hpp"
#include "tools/parlour/reference/function_entry.hpp"
#include "tools/parlour/reference/role_entry.hpp"

namespace parlour::tools {

namespace {

using Entries = std::vector<Entry>;

// A page: its file name, its heading, its introduction, and where its entries
// come from.
struct Page {
  const char* name;
  const char* heading;
  const char* words;
  Entries (*entries)();
};

Entries elements() {
  auto entries = element_entries();
  entries.push_back(statements_entry());
  return entries;
}

constexpr Page pages[] = {
    {"elements", "Elements",
     "Each element: what it is, where it stands, its attributes, and an "
     "example that is tested.",
     &elements},
    {"functions", "Built-in functions",
     "Each function with what it gives; the examples are tested, on 21 "
     "November 2026 at 9:00.\n`?`: may be missing; `...`: any number.",
     &function_entries},
    {"roles", "Roles",
     "What components of each role understand (`<post>`, `<request>`) and "
     "fire (events for\n`<messages>`). `?`: may be missing. Positions and "
     "times are in ms, a confidence is 0 to 1.",
     &role_entries},
};

// Tells readers of the page not to edit it.
constexpr const char* printed =
    "It is printed from the tables by `parlour help --page ";

std::string page_of(const Page& page) {
  auto text = std::string("# ") + page.heading + "\n\n" + page.words + "\n" +
              printed + page.name + "`.\n";
  for (const auto& entry : page.entries())
    text += '\n' + entry_section(entry);
  return text;
}

// Links to all sections of a page, for the index.
std::string links_of(const Page& page) {
  std::vector<std::string> links;
  for (const auto& entry : page.entries())
    links.push_back(link_to(entry, std::string(page.name) + ".md"));
  return "\n## " + std::string("[") + page.heading + "](" + page.name +
         ".md)\n\n" + listed(links, " ·\n") + '\n';
}

std::string index() {
  std::string text = "# Reference\n\nEvery element, built-in function and "
                     "role. `parlour help NAME` tells the same of one of\n"
                     "them, of an attribute or of an event; `parlour help "
                     "WORD` finds who speaks of it.\n";
  text.append(printed).append("index`.\n");
  for (const auto& page : pages)
    text += links_of(page);
  return text;
}

} // namespace

std::vector<std::string> reference_pages() {
  std::vector<std::string> names{"index"};
  for (const auto& page : pages)
    names.emplace_back(page.name);
  return names;
}

std::string reference_page(const std::string& name) {
  for (const auto& page : pages)
    if (page.name == name)
      return page_of(page);
  return index();
}

} // namespace parlour::tools
