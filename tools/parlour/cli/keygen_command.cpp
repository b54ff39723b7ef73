#include <cerrno>
#include <cstring>
#include <ostream>
#include <string>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "adapters/agents/zeromq/key_pair.hpp"
#include "tools/parlour/cli/commands.hpp"
#include "tools/parlour/console/exit_code.hpp"

namespace parlour::tools {

namespace {

namespace fs = std::filesystem;

// As the value of an attribute: keys may have these characters.
std::string xml_of(const std::string& key) {
  std::string text;
  for (const char character : key)
    if (character == '&')
      text += "&amp;";
    else if (character == '<')
      text += "&lt;";
    else
      text += character;
  return text;
}

// The reason of the last system call that failed.
tl::unexpected<Error> trouble(const fs::path& file) {
  return fail(ErrorKind::file,
              fmt::format("{}: {}", file.string(), std::strerror(errno)));
}

// O_EXCL: of two that write the same file, only one makes it. A file that
// cannot be written to its end is removed.
Expected<void> write_new(const fs::path& file, const std::string& text) {
  const int descriptor = open(
      file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, S_IRUSR | S_IWUSR);
  if (descriptor < 0 && errno == EEXIST)
    return fail(ErrorKind::file,
                file.string() + " is there already; no key is overwritten");
  if (descriptor < 0)
    return trouble(file);
  const auto size = static_cast<ssize_t>(text.size());
  const bool written = write(descriptor, text.data(), text.size()) == size &&
                       fsync(descriptor) == 0;
  const auto outcome = written ? Expected<void>() : trouble(file);
  close(descriptor);
  if (!outcome)
    unlink(file.c_str());
  return outcome;
}

} // namespace

int keygen_command(const Places& places, const std::string& file,
                   const Console& console) {
  const auto path = places.working / file;
  const auto keys = adapters::agents::new_key_pair();
  if (!keys) {
    say_error(console, keys.error().message);
    return exit_code::wrong;
  }
  if (auto written = write_new(path, keys->secret_key + '\n'); !written) {
    say_error(console, written.error().message);
    return exit_code::wrong;
  }
  console.out << "public key: " << keys->public_key << "\nsecret key: in "
              << file
              << "\nsettings, for the agent NAME that has this key:\n"
                 "  <agents><agent name=\"NAME\" key=\""
              << xml_of(keys->public_key) << "\"/></agents>\n";
  return exit_code::success;
}

} // namespace parlour::tools
