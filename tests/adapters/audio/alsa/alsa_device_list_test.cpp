#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/audio/alsa/alsa_device_list.hpp"
#include "tests/adapters/audio/alsa/virtual_device.hpp"

namespace parlour::adapters {
namespace {

TEST(AlsaDeviceListTest, ListsDevices) {
  const test::VirtualDevice device;
  const auto devices = list_sound_devices();
  ASSERT_TRUE(devices);
  ASSERT_EQ(devices->size(), 1u); // not the one of the type null
  const auto& only = devices->front();
  EXPECT_EQ(only.name, "dev");
  EXPECT_EQ(only.description, "A device for tests, that is virtual");
  EXPECT_TRUE(only.captures);
  EXPECT_TRUE(only.plays);
}

TEST(AlsaDeviceListTest, ThereMayBeNone) {
  const test::TemporaryFolder folder;
  folder.write("asound.conf", "");
  setenv("ALSA_CONFIG_PATH", (folder.path() / "asound.conf").c_str(), 1);
  const auto devices = list_sound_devices();
  ASSERT_TRUE(devices);
  EXPECT_TRUE(devices->empty());
}

} // namespace
} // namespace parlour::adapters
