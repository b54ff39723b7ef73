#include "adapters/audio/alsa/device_stream.hpp"

#include <cerrno>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include "adapters/loop/wait_until_ready.hpp"

namespace parlour::adapters {

namespace {

using Steady = std::chrono::steady_clock;

// Of a capturing device, in one round: 100 ms of 48,000 samples of two
// channels.
constexpr std::size_t most_at_once = 9'600;
// A playing device that takes more than this in one round has no end.
constexpr int most_fills = 20;
// What a device may be ahead of the clock.
constexpr Milliseconds most_ahead{200};
// While poll() reports a device that then moves nothing.
constexpr Milliseconds idle_pause{5};

std::string reason_of(int error) {
  if (error == ENODEV)
    return "it is gone";
  if (error == ETIMEDOUT)
    return "it does not answer";
  if (error == EPIPE || error == ESTRPIPE)
    return "it fails again and again";
  return std::generic_category().message(error);
}

} // namespace

// What the threads share. The thread keeps it, so one that hangs harms nobody.
struct DeviceStream::Shared {
  Shared(const WantedDevice& device, const StreamLimits& some, StreamUser& its)
      : wanted(device), limits(some), wake(eventfd(0, EFD_NONBLOCK)),
        user(&its) {}
  Shared(const Shared&) = delete;
  Shared& operator=(const Shared&) = delete;
  ~Shared() {
    if (wake >= 0)
      ::close(wake);
  }

  // Calls the user, unless the stream has been stopped.
  template <class Action>
  void call(Action action) {
    std::lock_guard lock(mutex);
    if (user)
      action(*user);
  }

  const WantedDevice wanted;
  const StreamLimits limits;
  const int wake;
  std::thread thread;

  std::mutex mutex;
  std::condition_variable changed;
  StreamUser* user;                     // null once it is stopped
  std::optional<Expected<void>> opened; // for the first time
  bool ended = false;
};

namespace {

// What the thread does. Everything but `shared` belongs to it alone.
template <class Shared>
class Worker {
public:
  explicit Worker(std::shared_ptr<Shared> shared)
      : shared_(std::move(shared)), recovery_(shared_->limits.recovery) {}

  void run() {
    if (open_first())
      while (!stopped())
        round();
    device_.reset();
    std::lock_guard lock(shared_->mutex);
    shared_->ended = true;
    shared_->changed.notify_all();
  }

private:
  bool captures() const {
    return shared_->wanted.direction == SoundDirection::capture;
  }
  bool stopped() const {
    std::lock_guard lock(shared_->mutex);
    return !shared_->user;
  }

  bool open_first() {
    auto opened = open();
    const bool is_open = opened.has_value();
    std::lock_guard lock(shared_->mutex);
    shared_->opened = std::move(opened);
    shared_->changed.notify_all();
    return is_open;
  }

  Expected<void> open() {
    auto device = AlsaDevice::open(shared_->wanted);
    if (!device)
      return tl::make_unexpected(device.error());
    device_ = std::move(*device);
    running_ = false;
    pending_.clear();
    return {};
  }

  void round() {
    bool wanted = is_lost_;
    shared_->call([&](StreamUser& user) { wanted |= user.is_running(); });
    if (!wanted)
      return rest();
    if (!device_) {
      if (auto opened = open(); !opened)
        return broken(opened.error().message);
    }
    if (!running_)
      return begin();
    if (wait_for_device())
      move();
  }

  // A microphone that nobody listens to is closed; a speaker stays open, so
  // that it speaks at once.
  void rest() {
    if (captures())
      device_.reset();
    else if (std::exchange(running_, false))
      device_->halt();
    failed_since_.reset();
    wait_until(Steady::time_point::max());
  }

  void begin() {
    idle_rounds_ = 0;
    if (const int error = device_->prepare(); error != 0)
      return fault(error);
    running_ = true;
    moved_at_ = began_ = Steady::now();
    moved_ = 0;
    shared_->call([&](StreamUser& user) { user.begin(device_->format()); });
    if (!captures())
      move();
  }

  // -- waiting
  // -----------------------------------------------------------------

  // Waits until the moment, or until somebody wakes the stream.
  void wait_until(Steady::time_point moment) {
    pollfd wake{shared_->wake, POLLIN, 0};
    if (wait_until_ready({&wake, 1}, moment) == Waited::ready)
      drain();
  }
  void drain() const {
    std::uint64_t count = 0;
    (void)!::read(shared_->wake, &count, sizeof count);
  }
  // What wakes the stream does not make a device better.
  void pause(Milliseconds time) {
    const auto end = Steady::now() + time;
    while (!stopped() && Steady::now() < end)
      wait_until(end);
  }

  // True once the device may move something. A device that only says so, again
  // and again, is asked less often.
  bool wait_for_device() {
    if (const auto moment = too_fast_until(); moment > Steady::now()) {
      moved_at_ = moment;
      wait_until(moment);
      return false;
    }
    if (idle_rounds_ > 3)
      pause(idle_pause);
    auto waited = device_->descriptors();
    waited.push_back({shared_->wake, POLLIN, 0});
    const auto outcome =
        wait_until_ready(waited, moved_at_ + shared_->limits.hang);
    if (waited.back().revents != 0)
      drain();
    waited.pop_back();
    if (Steady::now() - moved_at_ >= shared_->limits.hang)
      return fault(ETIMEDOUT), false;
    if (outcome == Waited::failed)
      return fault(EIO), false;
    const bool is_ready = outcome == Waited::ready && device_->is_ready(waited);
    if (!is_ready)
      ++idle_rounds_;
    return is_ready;
  }

  // When a device that is faster than the clock may go on.
  Steady::time_point too_fast_until() const {
    const auto& format = device_->format();
    const auto sound =
        static_cast<double>(moved_) /
        (format.rate * format.channels * shared_->limits.fastest);
    return began_ - most_ahead +
           std::chrono::duration_cast<Steady::duration>(
               std::chrono::duration<double>(sound));
  }

  // -- sound
  // -------------------------------------------------------------------

  void move() {
    const auto [samples, error] = captures() ? capture() : play();
    if (error != 0)
      return fault(error);
    idle_rounds_ = samples > 0 ? 0 : idle_rounds_ + 1;
    if (samples == 0)
      return;
    moved_ += samples;
    moved_at_ = Steady::now();
    if (recovery_.works(moved_at_)) {
      is_lost_ = false;
      shared_->call([](StreamUser& user) { user.found(); });
    }
  }

  AlsaDevice::Moved capture() {
    std::vector<Sample> samples;
    const auto moved = device_->read(samples, most_at_once);
    if (!samples.empty())
      shared_->call(
          [&](StreamUser& user) { user.captured(samples, time_lost()); });
    return moved;
  }
  Milliseconds time_lost() {
    const auto since = std::exchange(failed_since_, std::nullopt);
    return since ? std::chrono::duration_cast<Milliseconds>(Steady::now() -
                                                            *since)
                 : Milliseconds::zero();
  }

  // Nothing is asked for before there is room for it, so that what has been
  // filled is heard soon.
  AlsaDevice::Moved play() {
    AlsaDevice::Moved all;
    for (int fills = 0; fills < most_fills && all.error == 0; ++fills) {
      const auto room = device_->room();
      all.error = room.error;
      if (room.error != 0 || (pending_.empty() && room.samples < least_room()))
        break;
      if (pending_.empty())
        shared_->call([&](StreamUser& user) { user.fill(pending_); });
      const auto moved = device_->write(pending_);
      all = {all.samples + moved.samples, moved.error};
      pending_.erase(pending_.begin(),
                     pending_.begin() +
                         static_cast<std::ptrdiff_t>(moved.samples));
      if (!pending_.empty())
        break;
    }
    const auto waiting = pending_.size() + device_->queued();
    shared_->call([&](StreamUser& user) { user.waiting(waiting); });
    return all;
  }
  // 10 ms.
  std::size_t least_room() const {
    const auto& format = device_->format();
    return static_cast<std::size_t>(format.rate / 100 * format.channels);
  }

  // -- failures
  // ----------------------------------------------------------------

  void fault(int error) {
    running_ = false;
    if (!failed_since_)
      failed_since_ = Steady::now();
    if (error == EPIPE || error == ESTRPIPE)
      if (const auto time = recovery_.glitch(Steady::now()))
        return pause(*time);
    broken(fmt::format("the sound device \"{}\" cannot be used now: {}",
                       shared_->wanted.name, reason_of(error)));
  }

  void broken(const std::string& reason) {
    device_.reset();
    running_ = false;
    if (!failed_since_)
      failed_since_ = Steady::now();
    const auto time = recovery_.broken(Steady::now());
    if (recovery_.must_report(Steady::now())) {
      is_lost_ = true;
      shared_->call([&](StreamUser& user) { user.lost(reason); });
    }
    pause(time);
  }

  const std::shared_ptr<Shared> shared_;
  DeviceRecovery recovery_;
  std::optional<AlsaDevice> device_;
  bool running_ = false;
  bool is_lost_ = false; // as the user was told
  std::vector<Sample> pending_;
  Steady::time_point began_{};
  Steady::time_point moved_at_{}; // when the device last moved something
  std::size_t moved_ = 0;         // samples since it began
  int idle_rounds_ = 0;
  std::optional<Steady::time_point> failed_since_;
};

} // namespace

// -- the thread's other side
// -----------------------------------------------------

DeviceStream::DeviceStream(std::shared_ptr<Shared> shared)
    : shared_(std::move(shared)) {}

Expected<std::unique_ptr<DeviceStream>>
DeviceStream::start(const WantedDevice& wanted, const StreamLimits& limits,
                    StreamUser& user) {
  auto shared = std::make_shared<Shared>(wanted, limits, user);
  if (shared->wake < 0)
    return fail(ErrorKind::limit, "the system has no descriptors left");
  shared->thread = std::thread([shared] { Worker<Shared>(shared).run(); });
  std::unique_ptr<DeviceStream> stream(new DeviceStream(shared));
  std::unique_lock lock(shared->mutex);
  shared->changed.wait_for(lock, limits.patience,
                           [&] { return shared->opened.has_value(); });
  const auto opened = shared->opened;
  lock.unlock();
  if (!opened)
    return fail(
        ErrorKind::offline,
        fmt::format("the sound device \"{}\" does not answer", wanted.name));
  if (!*opened)
    return tl::make_unexpected(opened->error());
  return stream;
}

DeviceStream::~DeviceStream() {
  stop();
}

void DeviceStream::wake() {
  const std::uint64_t one = 1;
  (void)!::write(shared_->wake, &one, sizeof one);
}

bool DeviceStream::stop() {
  if (!shared_->thread.joinable())
    return true;
  std::unique_lock lock(shared_->mutex);
  shared_->user = nullptr;
  lock.unlock();
  wake();
  lock.lock();
  const bool ended = shared_->changed.wait_for(lock, shared_->limits.patience,
                                               [&] { return shared_->ended; });
  lock.unlock();
  if (ended)
    shared_->thread.join();
  else
    shared_->thread.detach();
  return ended;
}

} // namespace parlour::adapters
