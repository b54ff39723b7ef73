// The line editor.
//
// libedit asks Editor::next_character for each key. It waits for a key, an
// interrupt, or `news`, an eventfd that add() writes to. So other threads can
// add output while the user types, and only the reading thread touches the
// terminal.
#include "tools/parlour/talk/terminal_run.hpp"

#include <algorithm>
#include <cstring>
#include <cwchar>
#include <vector>

#include <histedit.h>
#include <sys/eventfd.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "adapters/loop/wait_until_ready.hpp"
#include "tools/parlour/console/line_reader.hpp"

namespace parlour::tools {

namespace {

constexpr int kept_lines = 1000; // of the history
constexpr int min_columns = 70;  // that leave room beside a status

constexpr const wchar_t* plain_prompt = L"> ";

// The terminal's width; 80 if it is not known.
int columns_of(std::FILE* terminal) {
  winsize size{};
  const auto known = ioctl(fileno(terminal), TIOCGWINSZ, &size) == 0;
  return known && size.ws_col > 0 ? size.ws_col : 80;
}

} // namespace

// libedit's objects. One object for each Screen, used by the reading thread
// only.
struct Screen::Editor {
  Editor(Screen* owner, const Terminal& both_ends, std::string history_file,
         IsPrivate asks)
      : screen(owner), terminal(both_ends),
        news(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)),
        file(std::move(history_file)), is_private(std::move(asks)) {
    line = el_init("parlour", terminal.in, terminal.out, terminal.out);
    past = history_init();
    HistEvent event;
    history(past, &event, H_SETSIZE, kept_lines);
    history(past, &event, H_LOAD, file.c_str());
    el_wset(line, EL_PROMPT, &Editor::show_prompt);
    el_wset(line, EL_EDITOR, L"emacs");
    el_set(line, EL_HIST, history, past);
    el_set(line, EL_CLIENTDATA, this);
    el_wset(line, EL_GETCFN, &Editor::next_character);
  }
  Editor(const Editor&) = delete;
  Editor& operator=(const Editor&) = delete;
  ~Editor() {
    forget_what_is_private();
    HistEvent event;
    history(past, &event, H_SAVE, file.c_str());
    history_end(past);
    el_end(line);
    close(news);
  }

  static const wchar_t* show_prompt(EditLine* line) {
    Editor* self = nullptr;
    el_get(line, EL_CLIENTDATA, &self);
    return self ? self->prompt.c_str() : plain_prompt;
  }

  // A status of ASCII; where the terminal is too narrow for it there is none.
  void set_status(const std::string& status) {
    prompt = plain_prompt;
    if (!status.empty() && columns_of(terminal.out) > min_columns)
      prompt = std::wstring(status.begin(), status.end()) + L" " + prompt;
  }

  // Goes through the history from the oldest line to the newest and keeps what
  // is not private.
  void forget_what_is_private() {
    std::vector<std::string> kept;
    HistEvent event;
    for (int found = history(past, &event, H_LAST); found >= 0;
         found = history(past, &event, H_PREV)) {
      const std::string words(event.str, std::strcspn(event.str, "\r\n"));
      if (!is_private || !is_private(words))
        kept.emplace_back(event.str);
    }
    history(past, &event, H_CLEAR);
    for (const auto& entry : kept)
      history(past, &event, H_ENTER, entry.c_str());
  }

  // Waits for a key, and shows output while it waits. Returns the number of
  // characters; 0 at the end of the input, or if nothing can be waited for
  // (libedit's EL_GETCFN).
  static int next_character(EditLine* line, wchar_t* character) {
    Editor* self = nullptr;
    el_get(line, EL_CLIENTDATA, &self);
    for (;;) {
      pollfd waiting[] = {{self->terminal.interrupt, POLLIN, 0},
                          {self->news, POLLIN, 0},
                          {fileno(self->terminal.in), POLLIN, 0}};
      if (adapters::wait_until_ready(waiting) == adapters::Waited::failed ||
          waiting[0].revents)
        return 0;
      if (waiting[1].revents)
        self->show_news();
      else if (waiting[2].revents)
        return self->read_character(character);
    }
  }

  // Reads one character, byte by byte. Invalid UTF-8 becomes U+FFFD.
  int read_character(wchar_t* character) const {
    std::mbstate_t state{};
    for (;;) {
      char byte;
      if (::read(fileno(terminal.in), &byte, 1) != 1)
        return 0;
      const auto size = std::mbrtowc(character, &byte, 1, &state);
      // No character starts with these bytes.
      if (size == static_cast<std::size_t>(-1)) {
        *character = L'\xFFFD';
        return 1;
      }
      if (size != static_cast<std::size_t>(-2))
        return 1;
    }
  }

  // Clears the line that is being typed, prints the output, and lets libedit
  // draw the line again below it.
  void show_news() {
    if (const auto above = rows_above_cursor(); above > 0)
      std::fprintf(terminal.out, "\033[%dA", above);
    std::fputs("\r\033[J", terminal.out);
    screen->flush();
    el_set(line, EL_REFRESH);
  }

  // The number of rows between the cursor and the prompt, where the line is
  // longer than the terminal is wide.
  int rows_above_cursor() const {
    const auto* written = el_wline(line);
    auto columns = static_cast<int>(prompt.size());
    for (const auto* at = written->buffer; at != written->cursor; ++at)
      columns += std::max(wcwidth(*at), 0);
    return columns / columns_of(terminal.out);
  }

  Screen* screen;    // owns this
  Terminal terminal; // owned by the caller
  int news;          // eventfd: output waits
  // The history file.
  std::string file;
  IsPrivate is_private; // may be empty
  std::wstring prompt = plain_prompt;
  EditLine* line = nullptr;
  History* past = nullptr;
};

Screen::Screen(const Terminal& terminal, std::filesystem::path history,
               bool colour, IsPrivate is_private)
    : colour_(colour),
      editor_(std::make_unique<Editor>(this, terminal, history.string(),
                                       std::move(is_private))) {}

Screen::~Screen() = default;

void Screen::say(const std::string& text) {
  add(colour_ ? "\033[1m" + text + "\033[0m" : text);
}

void Screen::note(const std::string& text) {
  add(colour_ ? "\033[90m" + text + "\033[0m" : text);
}

void Screen::status(const std::string& text) {
  std::lock_guard lock(mutex_);
  status_ = text;
  eventfd_write(editor_->news, 1);
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
    std::fprintf(editor_->terminal.out, "%s\n", line.c_str());
  lines_.clear();
  editor_->set_status(status_);
  std::fflush(editor_->terminal.out);
}

// Shows what waits, then reads. The line is made valid UTF-8, like piped input.
std::optional<std::string> Screen::read_line() {
  flush();
  int size = 0;
  const auto* text = el_gets(editor_->line, &size);
  if (!text || size <= 0) {
    std::fputc('\n', editor_->terminal.out);
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

void talk_on_terminal(ConversationDriver& driver, Screen& screen) {
  while (const auto line = screen.read_line()) {
    if (!is_blank(*line)) {
      driver.enter({*line});
      if (driver.is_virtual())
        driver.run_until_quiet();
    } else if (driver.is_virtual()) {
      driver.let_time_pass();
    }
  }
}

} // namespace parlour::tools
