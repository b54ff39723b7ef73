#include "adapters/standins/log_devices.hpp"
#include "tests/tools/parlour/application_fixture.hpp"
#include "tools/parlour/application/node_options.hpp"

namespace parlour::tools {
namespace {

TEST_F(ApplicationTest, gives_a_node_all_it_needs) {
  const auto greeter = load("greeter");
  const auto options =
      node_options(greeter, rehearsed(greeter.composition), {"/data", 5, 7});
  EXPECT_EQ(options.program, greeter.program);
  ASSERT_EQ(options.components.size(), 2u);
  EXPECT_EQ(options.components[0].name, "LogTelephone");
  EXPECT_EQ(options.components[1].options.count("file"), 0u);
  EXPECT_EQ(options.components[1].options.at("watch"), "0s");
  EXPECT_EQ(options.aliases.at("Record"), "Microphone");
  EXPECT_TRUE(options.phrases);
  EXPECT_EQ(options.columns("db:guest.name").value().size(), 1u);
  EXPECT_EQ(options.virtual_start, Timestamp(5));
  EXPECT_EQ(options.seed, 7u);
  EXPECT_EQ(options.data_folder, "/data");
  EXPECT_EQ(options.application_folder, greeter.folder.string());
}

// What the component is that a script loads by this name.
std::unique_ptr<IPlugin> loaded(const actors::NodeOptions& options,
                                const std::string& plugin) {
  actors::ComponentOrder order{plugin, *find_plugin(plugin), {}, {}};
  order.policy.host = "process";
  options.complete(order);
  return order.factory.create();
}

TEST_F(ApplicationTest, rehearses_what_scripts_load) {
  const auto greeter = load("greeter");
  const auto devices = [&](const Composition& composition) {
    const auto it = loaded(node_options(greeter, composition, {"/data", 5, 7}),
                           "MQTTDevices");
    return dynamic_cast<adapters::LogDevices*>(it.get()) != nullptr;
  };
  EXPECT_TRUE(devices(rehearsed(greeter.composition)));
  EXPECT_FALSE(devices(greeter.composition));
}

} // namespace
} // namespace parlour::tools
