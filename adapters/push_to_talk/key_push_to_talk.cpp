#include "adapters/push_to_talk/key_push_to_talk.hpp"

#include <utility>

#include <poll.h>

#include "adapters/loop/alarm.hpp"
#include "adapters/loop/watch.hpp"
#include "adapters/push_to_talk/key_source.hpp"
#include "adapters/push_to_talk/talk_switch.hpp"

namespace parlour::adapters {

namespace {

constexpr const char* terminal = "/dev/tty";

const std::vector<OptionDescription>& option_descriptions() {
  static const std::vector<OptionDescription> options = {
      {"device", "",
       "the input device, such as /dev/input/event3; else the terminal"},
      {"key", "space", "the key: space, f5, k, code-164, any"},
      {"press", "",
       "hold: as long as one talks; twice: to begin and to end; else hold, or "
       "twice on a terminal"}};
  return options;
}

struct WantedKey {
  std::string device; // empty: the terminal
  KeyName key;

  Expected<std::unique_ptr<KeySource>> open() const {
    return device.empty() ? KeySource::open_terminal(terminal, key)
                          : KeySource::open_device(device, key);
  }
};

std::string option(const Options& given, const char* name) {
  return option_value(given, option_descriptions(), name);
}

Expected<WantedKey> read_key(const Options& given) {
  return find_key(option(given, "key")).map([&](const KeyName& key) {
    return WantedKey{option(given, "device"), key};
  });
}

Expected<TalkBy> read_press(const std::string& press, bool is_terminal) {
  if (press.empty())
    return is_terminal ? TalkBy::twice : TalkBy::hold;
  if (press == "hold")
    return TalkBy::hold;
  if (press == "twice")
    return TalkBy::twice;
  return fail(ErrorKind::settings,
              "the option 'press' is \"hold\" or \"twice\"");
}

// Refuses the same options, and does nothing.
class UnpressedKey : public RolePlugin {
public:
  UnpressedKey() : RolePlugin("PushToTalk") {
    on("Enable", &UnpressedKey::ignore);
    on("Disable", &UnpressedKey::ignore);
  }

protected:
  Expected<void> on_start(const Options& given) override {
    const auto key = read_key(given);
    if (!key)
      return tl::make_unexpected(key.error());
    return read_press(option(given, "press"), key->device.empty())
        .map([](TalkBy) {});
  }

private:
  void ignore() {}
};

} // namespace

// Everything is done on the loop's thread once it has begun.
class KeyPushToTalk::Keyboard {
public:
  Keyboard(KeyPushToTalk& owner, WantedKey wanted, TalkBy by,
           std::unique_ptr<KeySource> source, std::unique_ptr<Loop> loop)
      : owner_(owner), wanted_(std::move(wanted)), switch_(by),
        source_(std::move(source)), loop_(std::move(loop)),
        watch_(*loop_, [this](short) { read(); }),
        alarm_(*loop_, [this] { is_due(); }) {
    loop_->post([this] { wait(); });
  }
  Keyboard(const Keyboard&) = delete;
  Keyboard& operator=(const Keyboard&) = delete;
  ~Keyboard() {
    loop_->stop();
  }

  void enable(bool is_enabled) {
    loop_->post([=, this] {
      is_enabled_ = is_enabled;
      if (!is_enabled)
        tell(switch_.reset());
    });
  }

private:
  using Clock = std::chrono::steady_clock;

  void wait() {
    watch_.await(source_->descriptor(), POLLIN);
  }

  void read() {
    std::vector<KeyMove> moves;
    const bool is_there = source_->read(moves);
    for (const auto move : moves)
      if (is_enabled_)
        take(move);
    if (!is_there)
      return lose();
    alarm_.set(switch_.due().value_or(Alarm::never));
    wait();
  }

  void take(KeyMove move) {
    switch (move) {
    case KeyMove::pressed:
      return tell(switch_.pressed());
    case KeyMove::released:
      return tell(switch_.released());
    case KeyMove::typed:
      return tell(switch_.typed(Clock::now()));
    }
  }

  void tell(TalkSwitch::Change change) {
    if (change)
      owner_.talks(*change);
  }

  void is_due() {
    if (!source_)
      return look_again();
    tell(switch_.passed(Clock::now()));
    alarm_.set(switch_.due().value_or(Alarm::never));
  }

  void lose() {
    watch_.stop();
    source_.reset();
    tell(switch_.reset());
    owner_.lost();
    alarm_.set(Clock::now() + owner_.retry_);
  }

  void look_again() {
    auto source = wanted_.open();
    if (!source) {
      alarm_.set(Clock::now() + owner_.retry_);
      return;
    }
    source_ = std::move(*source);
    owner_.found();
    wait();
  }

  KeyPushToTalk& owner_;
  const WantedKey wanted_;
  TalkSwitch switch_;
  bool is_enabled_ = true;
  std::unique_ptr<KeySource> source_; // null: it is lost
  const std::unique_ptr<Loop> loop_;
  Watch watch_;
  Alarm alarm_;
};

KeyPushToTalk::KeyPushToTalk(Milliseconds retry)
    : RolePlugin("PushToTalk"), retry_(retry) {
  on("Enable", &KeyPushToTalk::on_enable);
  on("Disable", &KeyPushToTalk::on_disable);
}

KeyPushToTalk::~KeyPushToTalk() = default;

Expected<void> KeyPushToTalk::on_start(const Options& given) {
  const auto wanted = read_key(given);
  if (!wanted)
    return tl::make_unexpected(wanted.error());
  const auto by = read_press(option(given, "press"), wanted->device.empty());
  if (!by)
    return tl::make_unexpected(by.error());
  auto source = wanted->open();
  if (!source)
    return tl::make_unexpected(source.error());
  auto loop =
      Loop::start([this](const std::string& what) { host().failed(what); });
  if (!loop)
    return tl::make_unexpected(loop.error());
  keyboard_ = std::make_unique<Keyboard>(*this, *wanted, *by,
                                         std::move(*source), std::move(*loop));
  return {};
}

void KeyPushToTalk::stop() {
  keyboard_.reset();
}

void KeyPushToTalk::on_enable() {
  keyboard_->enable(true);
}

void KeyPushToTalk::on_disable() {
  keyboard_->enable(false);
}

// -- on the loop's thread
// ------------------------------------------------------

void KeyPushToTalk::talks(bool talks) {
  answer({}, talks ? "Pressed" : "Released");
}

void KeyPushToTalk::lost() {
  host().log("The key for talking is gone; its device is looked for.");
  host().available(false);
}

void KeyPushToTalk::found() {
  host().log("The key for talking works again.");
  host().available(true);
}

PluginFactory key_push_to_talk_factory(Milliseconds retry) {
  return {{.name = "KeyPushToTalk",
           .roles = {"PushToTalk"},
           .sentence = "a key of the terminal or of an input device",
           .options = option_descriptions()},
          [retry] { return std::make_unique<KeyPushToTalk>(retry); }};
}

PluginFactory unpressed_key_factory() {
  return {key_push_to_talk_factory().description,
          [] { return std::make_unique<UnpressedKey>(); }};
}

} // namespace parlour::adapters
