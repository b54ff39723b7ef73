#include <condition_variable>
#include <mutex>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "adapters/audio/alsa/device_stream.hpp"
#include "tests/adapters/audio/alsa/virtual_device.hpp"

namespace parlour::adapters {
namespace {

using testing::HasSubstr;

// Plays a sample for ever, and notes what it is told.
class Player : public StreamUser {
public:
  bool is_running() override {
    std::lock_guard lock(mutex);
    return runs;
  }
  void begin(const PcmFormat&) override {
    note(begins);
  }
  void fill(std::vector<Sample>& samples) override {
    samples.insert(samples.end(), 160, 9);
    note(fills);
  }
  void lost(const std::string&) override {
    note(losses);
  }
  void found() override {
    note(finds);
  }
  void note(int& what) {
    std::lock_guard lock(mutex);
    ++what;
    changed.notify_all();
  }
  bool wait_for(const int& what, int count) {
    std::unique_lock lock(mutex);
    return changed.wait_for(lock, std::chrono::seconds(20),
                            [&] { return what >= count; });
  }
  void run(bool wanted) {
    std::lock_guard lock(mutex);
    runs = wanted;
  }

  std::mutex mutex;
  std::condition_variable changed;
  bool runs = false;
  int begins = 0;
  int fills = 0;
  int losses = 0;
  int finds = 0;
};

const WantedDevice wanted{"dev", SoundDirection::playback, Milliseconds(40)};

TEST(DeviceStreamTest, DoesNothingUnlessItIsWanted) {
  const test::VirtualDevice device;
  Player player;
  auto stream =
      DeviceStream::start(wanted, test::VirtualDevice::limits(), player);
  ASSERT_TRUE(stream);
  EXPECT_EQ(player.fills, 0);
  player.run(true);
  (*stream)->wake();
  EXPECT_TRUE(player.wait_for(player.fills, 100));
  EXPECT_TRUE((*stream)->stop());
  EXPECT_TRUE((*stream)->stop());
  const auto fills = player.fills;
  (*stream)->wake();
  stream->reset();
  EXPECT_EQ(player.fills, fills);
  EXPECT_EQ(player.begins, 1);
}

TEST(DeviceStreamTest, SaysWhyThereIsNoDevice) {
  const test::VirtualDevice device;
  Player player;
  EXPECT_THAT(DeviceStream::start({"none", SoundDirection::capture},
                                  test::VirtualDevice::limits(), player)
                  .error()
                  .message,
              HasSubstr("no such sound device"));
}

TEST(DeviceStreamTest, TellsOnceThatADeviceIsLostAndThatItIsFound) {
  const test::VirtualDevice device(
      {16'000, 1, "S16_LE", 10, "unplug@1600 unplug@16000"});
  Player player;
  player.run(true);
  auto stream =
      DeviceStream::start(wanted, test::VirtualDevice::limits(), player);
  ASSERT_TRUE(stream);
  for (const int times : {1, 2}) {
    ASSERT_TRUE(player.wait_for(player.losses, times));
    player.run(false); // looked for nevertheless
    device.plug_in();
    ASSERT_TRUE(player.wait_for(player.finds, times));
    player.run(true);
    (*stream)->wake();
  }
  EXPECT_TRUE((*stream)->stop());
  EXPECT_EQ(player.losses, 2);
}

} // namespace
} // namespace parlour::adapters
