// A sound device for tests: an ioplug device of alsa-lib, loaded by the
// configuration that VirtualDevice writes. It is paced by a timer, faster than
// the clock by a factor, captures from a file and plays to one, both with the
// raw bytes of its format, and fails where it is told to:
//
//  xrun@N suspend@N   in the state of that name, N frames after the first one
//  unplug@N           gone; it cannot be opened while the file `gone` is there,
//                     which it makes
//  hang@N             nothing moves any more, and poll() reports nothing
//  block@N            transfers do not return while the file `blocked` is
//  there;
//                     `gone` is there from then on until the device is closed
//
// A test that makes the file `pulled` unplugs it at that moment, as unplug@N.
//
// While the file `taken` is there, another program has the device; the
// configuration need not name one.
//
// A microphone with `lines` removes its file when it has captured all of it,
// and begins with the next one of that name. With `echo`, the file of a
// speaker, it also hears what that plays, weaker by `loss` dB and later by
// `delay` ms; both are mono and of 16 bit.
//
// Each fault comes once; frames are counted on when the device is opened anew.
// Whoever is late causes no xrun: the device waits. So tests come out alike on
// a busy machine.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include <alsa/asoundlib.h>
#include <alsa/pcm_external.h>
#include <fcntl.h>
#include <sys/timerfd.h>
#include <unistd.h>

namespace {

using Steady = std::chrono::steady_clock;
using Frames = snd_pcm_uframes_t;

struct Fault {
  std::string name;
  Frames at;
};

// What outlives one opening of a device.
struct Past {
  Frames frames = 0; // that have passed
  long bytes = 0;    // of the captured file
  std::size_t faults = 0;
  // What a speaker played, and since when it played from which frame on.
  std::vector<short> played;
  std::vector<std::pair<Steady::time_point, Frames>> starts;
};

// Devices have threads of their own.
std::mutex mutex;
std::map<std::string, Past> pasts;

struct Device {
  snd_pcm_ioplug_t plug{};
  std::string file, gone, blocked, pulled;
  std::vector<Fault> faults;
  double speed = 1;
  Past* past = nullptr;
  Frames base = 0;        // of `past`, when the stream was prepared
  Frames transferred = 0; // since then
  Frames passed = 0;      // since then
  Steady::time_point started{};
  bool hangs = false;
  bool blocks = false;
  bool lines = false;
  std::string echo;
  double loss = 0;
  double delay = 0; // seconds of the clock
};

Device& device_of(snd_pcm_ioplug_t* plug) {
  return *static_cast<Device*>(plug->private_data);
}

bool captures(const Device& device) {
  return device.plug.stream == SND_PCM_STREAM_CAPTURE;
}

void set_timer(const Device& device, bool runs) {
  const auto period = static_cast<double>(device.plug.period_size) /
                      device.plug.rate / device.speed * 1e9;
  itimerspec times{};
  if (runs)
    times.it_interval.tv_nsec = times.it_value.tv_nsec =
        std::clamp(static_cast<long>(period), 200'000L, 999'999'999L);
  timerfd_settime(device.plug.poll_fd, 0, &times, nullptr);
}

void touch(const std::string& file) {
  close(open(file.c_str(), O_CREAT | O_WRONLY | O_CLOEXEC, 0600));
}

// Carries a fault out once the stream has come to it; false if that was an
// xrun.
bool meet(Device& device, const Fault& fault) {
  ++device.past->faults;
  if (fault.name == "suspend")
    device.plug.state = SND_PCM_STATE_SUSPENDED;
  if (fault.name == "unplug") {
    device.plug.state = SND_PCM_STATE_DISCONNECTED;
    touch(device.gone);
  }
  device.hangs |= fault.name == "hang";
  device.blocks |= fault.name == "block";
  if (device.hangs)
    set_timer(device, false);
  return fault.name != "xrun";
}

// Whether a test unplugs it now.
bool is_pulled(Device& device) {
  if (device.pulled.empty() || std::remove(device.pulled.c_str()) != 0)
    return false;
  device.plug.state = SND_PCM_STATE_DISCONNECTED;
  touch(device.gone);
  return true;
}

int start(snd_pcm_ioplug_t* plug) {
  auto& device = device_of(plug);
  device.started = Steady::now();
  std::lock_guard lock(mutex);
  device.past->starts.emplace_back(device.started, device.base);
  set_timer(device, true);
  return 0;
}

int stop(snd_pcm_ioplug_t* plug) {
  set_timer(device_of(plug), false);
  return 0;
}

int prepare(snd_pcm_ioplug_t* plug) {
  auto& device = device_of(plug);
  device.base = device.past->frames;
  device.passed = device.transferred = 0;
  return 0;
}

// The frames that have passed, up to the next fault; below zero for an xrun.
snd_pcm_sframes_t pointer(snd_pcm_ioplug_t* plug) {
  auto& device = device_of(plug);
  if (plug->state != SND_PCM_STATE_RUNNING || device.hangs || is_pulled(device))
    return static_cast<snd_pcm_sframes_t>(device.passed);
  const std::chrono::duration<double> time = Steady::now() - device.started;
  const auto most =
      device.transferred + (captures(device) ? plug->buffer_size : 0);
  auto passed = std::min(
      most, static_cast<Frames>(time.count() * device.speed * plug->rate));
  const auto next = device.past->faults;
  const bool fails = next < device.faults.size() &&
                     device.base + passed >= device.faults[next].at;
  if (fails)
    passed =
        device.faults[next].at - std::min(device.base, device.faults[next].at);
  device.passed = std::max(device.passed, passed);
  device.past->frames = device.base + device.passed;
  if (fails && !meet(device, device.faults[next]))
    return -1;
  return static_cast<snd_pcm_sframes_t>(device.passed);
}

std::chrono::duration<double> time_of(const Device& device, Frames frames) {
  return std::chrono::duration<double>(static_cast<double>(frames) /
                                       device.plug.rate / device.speed);
}

bool is_plain(const Device& device) {
  return device.plug.format == SND_PCM_FORMAT_S16_LE &&
         device.plug.channels == 1;
}

void add_echo(const Device& device, short* samples, Frames count) {
  std::lock_guard lock(mutex);
  const auto& other = pasts[device.echo];
  const auto factor = std::pow(10, -device.loss / 20);
  for (Frames i = 0; i < count; ++i) {
    const auto now = device.started + time_of(device, device.transferred + i) -
                     std::chrono::duration<double>(device.delay);
    const auto after =
        std::find_if(other.starts.begin(), other.starts.end(),
                     [&](const auto& start) { return start.first > now; });
    if (after == other.starts.begin())
      continue;
    const std::chrono::duration<double> since = now - std::prev(after)->first;
    const auto at =
        std::prev(after)->second +
        static_cast<Frames>(since.count() * device.speed * device.plug.rate);
    const auto end =
        after == other.starts.end() ? other.played.size() : after->second;
    if (at < std::min<std::size_t>(end, other.played.size()))
      samples[i] = static_cast<short>(std::clamp(
          samples[i] + factor * other.played[at], -32768.0, 32767.0));
  }
}

void keep_played(const Device& device, const char* bytes, Frames count) {
  std::lock_guard lock(mutex);
  auto& played = device.past->played;
  played.resize(device.base + device.transferred);
  const auto* const samples = reinterpret_cast<const short*>(bytes);
  played.insert(played.end(), samples, samples + count);
}

// Behind the end of the file there is silence.
void move_bytes(Device& device, char* bytes, std::size_t size) {
  if (captures(device)) {
    std::memset(bytes, 0, size);
    if (auto* file = std::fopen(device.file.c_str(), "rbe")) {
      std::fseek(file, device.past->bytes, SEEK_SET);
      const auto read = std::fread(bytes, 1, size, file);
      std::fclose(file);
      device.past->bytes += static_cast<long>(size);
      if (device.lines && read < size) {
        std::remove(device.file.c_str());
        device.past->bytes = 0;
      }
    } else if (!device.lines) {
      device.past->bytes += static_cast<long>(size);
    }
  } else if (auto* file = std::fopen(device.file.c_str(), "abe")) {
    std::fwrite(bytes, 1, size, file);
    std::fclose(file);
  }
}

snd_pcm_sframes_t transfer(snd_pcm_ioplug_t* plug,
                           const snd_pcm_channel_area_t* areas, Frames offset,
                           Frames size) {
  auto& device = device_of(plug);
  if (device.blocks)
    touch(device.gone);
  while (device.blocks && access(device.blocked.c_str(), F_OK) == 0)
    usleep(1'000);
  auto* bytes = static_cast<char*>(areas->addr) +
                (areas->first + areas->step * offset) / 8;
  move_bytes(device, bytes, size * areas->step / 8);
  if (!captures(device) && is_plain(device))
    keep_played(device, bytes, size);
  else if (captures(device) && !device.echo.empty())
    add_echo(device, reinterpret_cast<short*>(bytes), size);
  device.transferred += size;
  return static_cast<snd_pcm_sframes_t>(size);
}

int poll_revents(snd_pcm_ioplug_t* plug, pollfd*, unsigned,
                 unsigned short* events) {
  std::uint64_t ticks = 0;
  (void)!read(plug->poll_fd, &ticks, sizeof ticks);
  *events = plug->stream == SND_PCM_STREAM_CAPTURE ? POLLIN : POLLOUT;
  return 0;
}

// The file tells a test that a thread has come back from a device that blocked.
int close_device(snd_pcm_ioplug_t* plug) {
  if (device_of(plug).blocks)
    std::remove(device_of(plug).gone.c_str());
  close(plug->poll_fd);
  delete &device_of(plug);
  return 0;
}

// Its resume() would always be a success, so none is here.
const snd_pcm_ioplug_callback_t callbacks = [] {
  snd_pcm_ioplug_callback_t all{};
  all.start = start;
  all.stop = stop;
  all.prepare = prepare;
  all.pointer = pointer;
  all.transfer = transfer;
  all.poll_revents = poll_revents;
  all.close = close_device;
  return all;
}();

std::string text(snd_config_t* config, const char* name) {
  snd_config_t* entry = nullptr;
  const char* value = "";
  if (snd_config_search(config, name, &entry) >= 0)
    snd_config_get_string(entry, &value);
  return value;
}

std::vector<Fault> faults_of(const std::string& all) {
  std::vector<Fault> faults;
  for (std::size_t at = 0; at < all.size();) {
    const auto end = std::min(all.find(' ', at), all.size());
    const auto mark = all.find('@', at);
    faults.push_back({all.substr(at, mark - at),
                      std::stoul(all.substr(mark + 1, end - mark - 1))});
    at = end + 1;
  }
  return faults;
}

int constrain(snd_pcm_ioplug_t& plug, snd_config_t* config) {
  int error = 0;
  const auto only = [&](int kind, unsigned long value) {
    const auto one = static_cast<unsigned>(value);
    if (error >= 0)
      error = snd_pcm_ioplug_set_param_list(&plug, kind, 1, &one);
  };
  only(SND_PCM_IOPLUG_HW_ACCESS, SND_PCM_ACCESS_RW_INTERLEAVED);
  only(SND_PCM_IOPLUG_HW_FORMAT,
       static_cast<unsigned long>(
           snd_pcm_format_value(text(config, "format").c_str())));
  only(SND_PCM_IOPLUG_HW_RATE, std::stoul(text(config, "rate")));
  only(SND_PCM_IOPLUG_HW_CHANNELS, std::stoul(text(config, "channels")));
  return error;
}

} // namespace

extern "C" {

SND_PCM_PLUGIN_DEFINE_FUNC(vdev) {
  (void)root;
  const auto gone = text(conf, "gone");
  if (access(gone.c_str(), F_OK) == 0)
    return -ENODEV;
  if (access(text(conf, "taken").c_str(), F_OK) == 0)
    return -EBUSY;
  auto* device = new Device;
  device->file = text(conf, "file");
  device->gone = gone;
  device->blocked = text(conf, "blocked");
  device->pulled = text(conf, "pulled");
  device->faults = faults_of(text(conf, "faults"));
  device->speed = std::stod(text(conf, "speed"));
  device->lines = !text(conf, "lines").empty();
  device->echo = text(conf, "echo");
  if (!device->echo.empty()) {
    device->loss = std::stod(text(conf, "loss"));
    device->delay = std::stod(text(conf, "delay")) / 1'000 / device->speed;
  }
  std::lock_guard lock(mutex);
  device->past = &pasts[device->file];
  auto& plug = device->plug;
  plug.version = SND_PCM_IOPLUG_VERSION;
  plug.name = "a device for tests";
  plug.flags = SND_PCM_IOPLUG_FLAG_BOUNDARY_WA;
  plug.poll_fd = timerfd_create(CLOCK_MONOTONIC, TFD_NONBLOCK | TFD_CLOEXEC);
  plug.poll_events = POLLIN;
  plug.callback = &callbacks;
  plug.private_data = device;
  int error = snd_pcm_ioplug_create(&plug, name, stream, mode);
  if (error < 0)
    return error;
  error = constrain(plug, conf);
  if (error < 0) {
    snd_pcm_ioplug_delete(&plug);
    return error;
  }
  *pcmp = plug.pcm;
  return 0;
}

SND_PCM_PLUGIN_SYMBOL(vdev);
}
