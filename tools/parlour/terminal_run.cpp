#include "tools/parlour/terminal_run.hpp"

#include <cstdio>

#include <histedit.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include "tools/parlour/line_reader.hpp"

namespace parlour::tools {

namespace {

constexpr int kept_lines = 1000; // of history

const wchar_t* prompt(EditLine*) {
  return L"> ";
}

} // namespace

struct Screen::Editor {
  Editor(Screen* owner, int interrupt_descriptor, std::string history_file)
      : screen(owner), interrupt(interrupt_descriptor),
        news(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)),
        file(std::move(history_file)) {
    line = el_init("parlour", stdin, stdout, stderr);
    past = history_init();
    HistEvent event;
    history(past, &event, H_SETSIZE, kept_lines);
    history(past, &event, H_LOAD, file.c_str());
    el_wset(line, EL_PROMPT, prompt);
    el_wset(line, EL_EDITOR, L"emacs");
    el_set(line, EL_HIST, history, past);
    el_set(line, EL_CLIENTDATA, this);
    el_wset(line, EL_GETCFN, &Editor::next_character);
  }
  Editor(const Editor&) = delete;
  Editor& operator=(const Editor&) = delete;
  ~Editor() {
    HistEvent event;
    history(past, &event, H_SAVE, file.c_str());
    history_end(past);
    el_end(line);
    close(news);
  }

  // Waits for a key; meanwhile the robot may speak.
  static int next_character(EditLine* line, wchar_t* character) {
    Editor* self = nullptr;
    el_get(line, EL_CLIENTDATA, &self);
    for (;;) {
      pollfd waiting[] = {{self->interrupt, POLLIN, 0},
                          {self->news, POLLIN, 0},
                          {STDIN_FILENO, POLLIN, 0}};
      if (poll(waiting, 3, -1) < 0)
        continue;
      if (waiting[0].revents)
        return 0;
      if (waiting[1].revents)
        self->show_news();
      else if (waiting[2].revents)
        return self->read_character(character);
    }
  }

  // A character of UTF-8; bytes that are none become U+FFFD.
  int read_character(wchar_t* character) {
    std::mbstate_t state{};
    for (;;) {
      char byte;
      if (::read(STDIN_FILENO, &byte, 1) != 1)
        return 0;
      const auto size = std::mbrtowc(character, &byte, 1, &state);
      if (size == static_cast<std::size_t>(-1)) {
        *character = L'\xFFFD';
        return 1;
      }
      if (size != static_cast<std::size_t>(-2))
        return 1;
    }
  }

  void show_news() {
    std::fputs("\r\033[K", stdout);
    screen->flush();
    el_set(line, EL_REFRESH);
  }

  Screen* screen;
  int interrupt;
  int news;
  std::string file;
  EditLine* line = nullptr;
  History* past = nullptr;
};

Screen::Screen(int interrupt, std::filesystem::path history, bool colour)
    : colour_(colour),
      editor_(std::make_unique<Editor>(this, interrupt, history.string())) {}

Screen::~Screen() = default;

void Screen::say(const std::string& text) {
  add(colour_ ? "\033[1m" + text + "\033[0m" : text);
}

void Screen::note(const std::string& text) {
  add(colour_ ? "\033[90m" + text + "\033[0m" : text);
}

void Screen::add(std::string line) {
  std::lock_guard lock(mutex_);
  lines_.push_back(std::move(line));
  eventfd_write(editor_->news, 1);
}

void Screen::flush() {
  std::lock_guard lock(mutex_);
  eventfd_t ignored;
  eventfd_read(editor_->news, &ignored);
  for (const auto& line : lines_)
    std::fprintf(stdout, "%s\n", line.c_str());
  lines_.clear();
  std::fflush(stdout);
}

std::optional<std::string> Screen::read_line() {
  flush();
  int size = 0;
  const auto* text = el_gets(editor_->line, &size);
  if (!text || size <= 0) {
    std::fputc('\n', stdout);
    return std::nullopt;
  }
  HistEvent event;
  if (!is_blank(text))
    history(editor_->past, &event, H_ENTER, text);
  LineReader reader;
  std::string_view bytes(text);
  auto line = reader.take(bytes);
  if (!line)
    line = reader.finish();
  return line ? line->text : std::string();
}

bool talk_on_terminal(Partner& partner, Screen& screen) {
  while (const auto line = screen.read_line()) {
    if (!is_blank(*line)) {
      partner.enter({*line});
      if (partner.is_virtual())
        partner.run_until_quiet();
    } else if (partner.is_virtual()) {
      partner.step_to_next_due();
    }
  }
  return true;
}

} // namespace parlour::tools
