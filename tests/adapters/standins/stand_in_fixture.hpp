// StandInTest: a stand-in with a data folder of its own.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/standins/stand_in.hpp"
#include "tests/support/fake_plugin_host.hpp"
#include "tests/support/temporary_folder.hpp"

namespace parlour::adapters {

class StandInTest : public testing::Test {
protected:
  StandInTest() {
    host.data = (folder.path() / "data").string();
    host.application = folder.path().string();
  }

  Expected<void> start(const PluginFactory& factory, const Options& options) {
    plugin = factory.create();
    return plugin->start(host, options);
  }

  std::vector<std::string> tell(std::string command,
                                std::vector<Value> params = {}) {
    plugin->receive(test::message(std::move(command), std::move(params)));
    return host.take_events();
  }

  std::string record(const std::string& name) const {
    return folder.read("data/records/" + name + ".log");
  }

  test::TemporaryFolder folder;
  test::FakePluginHost host;
  std::unique_ptr<IPlugin> plugin;
};

} // namespace parlour::adapters
