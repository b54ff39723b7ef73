#include <gtest/gtest.h>

#include "adapters/audio/alsa/device_recovery.hpp"

namespace parlour::adapters {
namespace {

class DeviceRecoveryTest : public testing::Test {
protected:
  void pass(int ms) {
    now += Milliseconds(ms);
  }

  DeviceRecovery::Moment now{};
  DeviceRecovery recovery;
};

TEST_F(DeviceRecoveryTest, AGlitchCostsNothing) {
  EXPECT_EQ(recovery.glitch(now), Milliseconds(0));
  EXPECT_FALSE(recovery.must_report(now));
}

TEST_F(DeviceRecoveryTest, ManyGlitchesAreABrokenDevice) {
  for (const int pause : {0, 5, 10, 20, 40, 80, 100, 100, 100, 100}) {
    EXPECT_EQ(recovery.glitch(now), Milliseconds(pause));
    EXPECT_FALSE(recovery.works(now)); // for a moment each time
    pass(pause);
  }
  EXPECT_EQ(recovery.glitch(now), std::nullopt);
}

TEST_F(DeviceRecoveryTest, GlitchesAreForgottenInTime) {
  for (int i = 0; i < 1'000; ++i) {
    ASSERT_EQ(recovery.glitch(now), Milliseconds(0)) << i;
    recovery.works(now);
    pass(1'000);
    recovery.works(now);
  }
}

TEST_F(DeviceRecoveryTest, AttemptsToOpenItBecomeRare) {
  for (const int pause : {50, 100, 200, 400, 800, 1'600, 3'200, 5'000, 5'000})
    EXPECT_EQ(recovery.broken(now), Milliseconds(pause));
  for (int i = 0; i < 10'000; ++i)
    ASSERT_EQ(recovery.broken(now), Milliseconds(5'000));
}

TEST_F(DeviceRecoveryTest, AnOutageIsReportedOnce) {
  recovery.broken(now);
  EXPECT_FALSE(recovery.must_report(now));
  pass(999);
  EXPECT_FALSE(recovery.must_report(now));
  pass(1);
  EXPECT_TRUE(recovery.must_report(now));
  recovery.broken(now);
  EXPECT_FALSE(recovery.must_report(now));
}

TEST_F(DeviceRecoveryTest, AnOutageEndsOnceTheDeviceHasWorkedForAWhile) {
  recovery.broken(now);
  pass(2'000);
  EXPECT_TRUE(recovery.must_report(now));
  EXPECT_FALSE(recovery.works(now));
  pass(999);
  EXPECT_FALSE(recovery.works(now));
  recovery.broken(now); // again
  pass(1);
  EXPECT_FALSE(recovery.works(now));
  pass(1'000);
  EXPECT_TRUE(recovery.works(now));
  EXPECT_FALSE(recovery.works(now));
  EXPECT_EQ(recovery.broken(now), Milliseconds(50));
}

TEST_F(DeviceRecoveryTest, AShortOutageIsNobodysBusiness) {
  recovery.broken(now);
  pass(500);
  recovery.works(now);
  pass(1'000);
  EXPECT_FALSE(recovery.works(now));
  recovery.broken(now);
  EXPECT_FALSE(recovery.must_report(now));
}

// A device that works for a moment between its failures is reported, too.
TEST_F(DeviceRecoveryTest, ALooseContactIsAnOutage) {
  for (int i = 0; i < 4; ++i) {
    recovery.broken(now);
    pass(300);
    EXPECT_FALSE(recovery.works(now));
  }
  EXPECT_TRUE(recovery.must_report(now));
}

} // namespace
} // namespace parlour::adapters
