#include "adapters/database/mariadb/mariadb_options.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

#include "adapters/database/option_values.hpp"
#include "runtime/base/file_bytes.hpp"

namespace parlour::adapters {

namespace {

namespace fs = std::filesystem;
using Tls = MariaDBOptions::Tls;

tl::unexpected<Error> wrong(const std::string& option,
                            const std::string& what) {
  return fail(ErrorKind::settings, "option '" + option + "' " + what);
}

// Whether the server is on this machine, so that no network is involved.
bool is_here(const MariaDBOptions& options) {
  return !options.socket.empty() || options.host == "localhost" ||
         options.host == "127.0.0.1" || options.host == "::1";
}

Expected<void> read_database(const OptionValues& values, MariaDBOptions& made) {
  made.database = values.text("database");
  // The name of an SQLite file is accepted: "lab.db" means the database "lab",
  // so that an application changes databases by changing the name of the
  // plug-in.
  if (made.database.empty())
    made.database = fs::path(values.text("file")).stem().string();
  const auto fits = [](unsigned char c) { return std::isalnum(c) || c == '_'; };
  // The name is pasted into statements, so its characters are restricted. 48
  // leaves room for the random suffix of a copy.
  if (made.database.empty() || made.database.size() > 48 ||
      !std::all_of(made.database.begin(), made.database.end(), fits))
    return wrong("database", "names the database in letters, digits and '_', "
                             "48 at most, not '" +
                                 made.database + "'");
  return {};
}

// Without the option, TLS is required and verified unless the server is on this
// machine.
void read_tls(const OptionValues& values, MariaDBOptions& made) {
  const auto said = values.text("tls");
  if (said.empty())
    made.tls = is_here(made) ? Tls::off : Tls::verify;
  else
    made.tls = said == "off"       ? Tls::off
               : said == "encrypt" ? Tls::encrypt
                                   : Tls::verify;
  made.tls_ca = values.text("tls-ca");
  made.tls_certificate = values.text("tls-certificate");
  made.tls_key = values.text("tls-key");
}

// A password file is read up to its first line break, which editors add.
Expected<void> read_password(const OptionValues& values, const fs::path& folder,
                             MariaDBOptions& made) {
  made.password = values.text("password");
  const fs::path name = values.text("password-file");
  if (name.empty())
    return {};
  if (!made.password.empty())
    return wrong("password-file", "and 'password' are both there; one is "
                                  "enough");
  const auto text = read_file(folder / name);
  if (!text)
    return wrong("password-file",
                 "names '" + name.string() + "': " + text.error().message);
  made.password = text->substr(0, text->find_first_of("\r\n"));
  if (made.password.empty())
    return wrong("password-file",
                 "names '" + name.string() + "', which has no first line");
  return {};
}

// Empty means the library's own port; 0 is no port.
Expected<void> read_port(const OptionValues& values, MariaDBOptions& made) {
  if (values.text("port").empty())
    return {};
  std::size_t port = 0;
  if (auto read = values.read("port", port); !read)
    return read;
  if (port > 65'535)
    return wrong("port", "is a number up to 65535");
  made.port = static_cast<unsigned>(port);
  return {};
}

} // namespace

const std::vector<OptionDescription>& mariadb_option_descriptions() {
  using Type = OptionType;
  static const auto descriptions = with_database_options({
      {"host", "localhost", "the machine that the server runs on", false},
      {"port", "", "its port; 3306 where nothing is said", false,
       Type::integer},
      {"socket", "", "the server's socket, on this machine", false},
      {"user", "", "who connects; who runs the program where nothing is said",
       false},
      {"password", "", "best as ${NAME}, which the environment fills", false},
      {"password-file", "", "a file whose first line is the password", false},
      {"database", "", "the database's name; else what 'file' is called",
       false},
      {"file", "", "as SQLiteDatabase has it: 'lab.db' is the database 'lab'",
       false},
      {"copy", "false",
       "a database of its own, made from schema and seed and dropped at the "
       "end: for tests",
       false, Type::boolean},
      {"one-by-one", "false",
       "answers each message before it takes the next: where time is virtual",
       false, Type::boolean},
      {"tls",
       "",
       "verify, the server's certificate too, holds for other machines where "
       "nothing is said",
       false,
       Type::choice,
       {"off", "encrypt", "verify"}},
      {"tls-ca", "", "the certificates that the server's must come from",
       false},
      {"tls-certificate", "", "the client's own certificate", false},
      {"tls-key", "", "its key", false},
      {"connections", "4", "the most at a time", false, Type::integer},
      {"connect-timeout", "5s", "how long connecting may take", false,
       Type::duration},
      {"query-timeout", "5s", "how long a statement may run", false,
       Type::duration},
  });
  return descriptions;
}

Expected<MariaDBOptions>
read_mariadb_options(const Options& options,
                     const std::string& application_folder) {
  const auto known = OptionValues::of(options, mariadb_option_descriptions());
  if (!known)
    return tl::make_unexpected(known.error());
  const auto& values = *known;
  MariaDBOptions made;
  made.host = values.text("host");
  made.socket = values.text("socket");
  made.user = values.text("user");
  made.copy = values.truth("copy");
  made.one_by_one = values.truth("one-by-one");
  made.connect_timeout = values.duration("connect-timeout");
  made.query_timeout = values.duration("query-timeout");
  read_tls(values, made);
  // The first error counts.
  for (auto&& read : {read_port(values, made), read_database(values, made),
                      read_password(values, application_folder, made),
                      read_database_options(values, application_folder, made),
                      values.read("connections", made.connections)})
    if (!read)
      return tl::make_unexpected(read.error());
  return made;
}

} // namespace parlour::adapters
