// Looks at every <load> element of the compiled documents.
#include "tools/parlour/application/plugins/load_check.hpp"

#include <algorithm>

#include "runtime/plugin/component_check.hpp"

namespace parlour::tools {

namespace {

using script::Attribute;
using script::Element;
using script::Severity;

// Whether the attribute holds no {expression}.
bool is_literal(const Attribute* attribute) {
  return attribute && attribute->value.find('{') == std::string::npos;
}

// Walks the elements and collects findings.
class LoadCheck {
public:
  LoadCheck(const script::Compiled& compiled, const Composition& composition,
            Catalogue& plugins)
      : compiled_(compiled), composition_(composition), plugins_(plugins) {}

  void look_at(const Element& element) {
    if (element.is("load"))
      check(element);
    for (const auto& child : element.children)
      look_at(child);
  }
  std::vector<script::Finding> take() {
    return std::move(findings_);
  }

private:
  // Without an attribute `name`, the component is called like its plug-in.
  void check(const Element& load) {
    const auto* plugin = load.attribute("plugin");
    const auto* given = load.attribute("name");
    const auto* name = given ? given : plugin;
    if (!is_literal(plugin) || !is_literal(name) || name->value.empty())
      return;
    const auto found = plugins_.find(plugin->value);
    // It may exist where the application will run.
    if (!found)
      return findings_.push_back(
          {Severity::warning, compiled_.findings.place(plugin->value_position),
           found.error().message, "unknown-module"});
    const auto description = described(found->description, name->value);
    // A wrong name given in `name` has been reported by the compiler.
    if (!given || wrong_source_name(given->value).empty())
      report(check_component(name->value, description), *name);
    // A <load> with the name of a running component replaces that component.
    for (const auto& component : composition_.components)
      if (component.name == name->value &&
          component.policy.scope.instances != 0)
        report(check_replacement(name->value, component.factory.description,
                                 description),
               *name);
  }

  // The plug-in as it will be with the options that the settings have for a
  // component of this name.
  PluginDescription described(PluginDescription plugin,
                              const std::string& name) const {
    for (const auto& component : composition_.components)
      if (component.name == name &&
          component.factory.description.name == plugin.name)
        return component.factory.description;
    return plugin;
  }

  // Adds the error, if there is one, at the attribute's value.
  void report(const Expected<void>& right, const Attribute& name) {
    if (!right)
      findings_.push_back({Severity::error,
                           compiled_.findings.place(name.value_position),
                           right.error().message});
  }

  const script::Compiled& compiled_;
  const Composition& composition_;
  Catalogue& plugins_;
  std::vector<script::Finding> findings_;
};

} // namespace

std::vector<script::Finding> check_loads(const script::Compiled& compiled,
                                         const Composition& composition,
                                         Catalogue& plugins) {
  LoadCheck check(compiled, composition, plugins);
  for (const auto& document : compiled.documents)
    check.look_at(document.root);
  return check.take();
}

} // namespace parlour::tools
