// LoadingTest: a catalogue of plug-ins that a test fills, and a script that
// loads and unloads them when the user says so.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "runtime/plugin/catalogue.hpp"
#include "tests/actors/node_fixture.hpp"

namespace parlour::actors {

class PluginShelf : public PluginCatalogue {
public:
  void put(const ComponentOrder& order) {
    factories_[order.name] = order.factory;
  }
  Expected<PluginFactory> find(const std::string& name) override {
    const auto found = factories_.find(name);
    if (found == factories_.end())
      return fail(ErrorKind::settings, "there is no plug-in '" + name + "'");
    return found->second;
  }
  std::vector<PluginDescription> all() override {
    return {};
  }

private:
  std::map<std::string, PluginFactory> factories_;
};

// "load X as Y" and "unload Y" do that; anything else is a request to book a
// taxi.
inline constexpr const char* load_and_ask = R"xml(
  <handler name="Pipeline"><messages><component>
    <ASR><RecognitionResult>
      <var name="words" expr="split(_LPARAM1)"/>
      <try>
        <switch expr="words[0]">
          <case value="load">
            <load plugin="{words[1]}" name="{words[3]}"/>
            <speak param="{words[3]} is up."/>
          </case>
          <case value="unload">
            <unload name="{words[1]}"/>
            <speak param="{words[1]} is gone."/>
          </case>
          <default>
            <request module="Taxi" command="Book" param="_LPARAM1"
                     return="reply"/>
            <speak param="{reply.params[0]}"/>
          </default>
        </switch>
        <catch name="e"><speak param="{e.kind}: {e.message}"/></catch>
      </try>
    </RecognitionResult></ASR>
    <System>
      <ComponentUp><log param="up {_LPARAM1} {_LPARAM2}"/></ComponentUp>
      <ComponentFailed><log param="failed {_LPARAM1}: {_LPARAM2} {_LPARAM3}"/>
      </ComponentFailed>
      <ComponentDown><log param="down {_LPARAM1}: {_LPARAM2}"/></ComponentDown>
    </System>
  </component></messages></handler>)xml";

// A component that answers with its own name and what it was asked.
inline ComponentOrder taxi(const std::string& name) {
  return component(name, "Taxi", [name](auto& self, const Message& message) {
    self.fire_event("Booked", {name + " for " + message.params.at(0).text()});
  });
}

class LoadingTest : public NodeFixture {
protected:
  LoadingTest() {
    options.plugins = shelf;
    watch = [this](const Inspection& seen) {
      if (seen.kind == InspectionKind::log)
        told.push_back(seen.detail);
    };
  }

  // What handlers have logged about System events since the last call.
  std::vector<std::string> heard() {
    return std::exchange(told, {});
  }

  std::shared_ptr<PluginShelf> shelf = std::make_shared<PluginShelf>();
  std::vector<std::string> told;
};

} // namespace parlour::actors
