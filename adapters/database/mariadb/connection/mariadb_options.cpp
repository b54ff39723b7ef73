#include "adapters/database/mariadb/connection/mariadb_options.hpp"

#include <algorithm>
#include <cctype>

#include "runtime/base/outside/file_bytes.hpp"

namespace parlour::adapters {

namespace {

namespace fs = std::filesystem;
using Tls = MariaDBOptions::Tls;

// Whether the server is on this machine, so that no network is involved.
bool is_here(const MariaDBOptions& options) {
  return !options.socket.empty() || options.host == "localhost" ||
         options.host == "127.0.0.1" || options.host == "::1";
}

void read_database(OptionReader& read, MariaDBOptions& made) {
  made.database = read.text("database");
  // The name of an SQLite file is accepted: "lab.db" means the database "lab",
  // so that an application changes databases by changing the name of the
  // plug-in.
  if (made.database.empty())
    made.database = fs::path(read.text("file")).stem().string();
  const auto fits = [](unsigned char c) { return std::isalnum(c) || c == '_'; };
  // The name is pasted into statements, so its characters are restricted. 48
  // leaves room for the random suffix of a copy.
  if (made.database.empty() || made.database.size() > 48 ||
      !std::all_of(made.database.begin(), made.database.end(), fits))
    read.wrong("database", "names the database in letters, digits and '_', 48 "
                           "at most, not '" +
                               made.database + "'");
}

// Without the option, TLS is required and verified unless the server is on this
// machine.
void read_tls(const OptionReader& read, MariaDBOptions& made) {
  const auto said = read.text("tls");
  if (said.empty())
    made.tls = is_here(made) ? Tls::off : Tls::verify;
  else
    made.tls = said == "off"       ? Tls::off
               : said == "encrypt" ? Tls::encrypt
                                   : Tls::verify;
  made.tls_ca = read.text("tls-ca");
  made.tls_certificate = read.text("tls-certificate");
  made.tls_key = read.text("tls-key");
}

// A password file is read up to its first line break, which editors add.
void read_password(OptionReader& read, const fs::path& folder,
                   MariaDBOptions& made) {
  made.password = read.text("password");
  const fs::path name = read.text("password-file");
  if (name.empty())
    return;
  if (!made.password.empty())
    return read.wrong("password-file", "and 'password' are both there; one is "
                                       "enough");
  const auto text = read_file(folder / name);
  if (!text)
    return read.wrong("password-file",
                      "names '" + name.string() + "': " + text.error().message);
  made.password = text->substr(0, text->find_first_of("\r\n"));
  if (made.password.empty())
    read.wrong("password-file",
               "names '" + name.string() + "', which has no first line");
}

// Empty means the library's own port.
void read_port(OptionReader& read, MariaDBOptions& made) {
  if (read.has("port"))
    made.port = static_cast<unsigned>(read.integer("port", 1, 65'535));
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
  OptionReader read(options, mariadb_option_descriptions());
  MariaDBOptions made;
  made.host = read.text("host");
  made.socket = read.text("socket");
  made.user = read.text("user");
  made.copy = read.truth("copy");
  made.one_by_one = read.truth("one-by-one");
  made.connect_timeout = read.duration("connect-timeout");
  made.query_timeout = read.duration("query-timeout");
  read_tls(read, made);
  read_port(read, made);
  read_database(read, made);
  read_password(read, application_folder, made);
  read_database_options(read, application_folder, made);
  made.connections = read.count("connections", 1);
  if (const auto outcome = read.outcome(); !outcome)
    return tl::make_unexpected(outcome.error());
  return made;
}

} // namespace parlour::adapters
