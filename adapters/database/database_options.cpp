#include "adapters/database/database_options.hpp"

#include <iterator>

#include "runtime/base/text/comma_list.hpp"

namespace parlour::adapters {

std::vector<OptionDescription>
with_database_options(std::vector<OptionDescription> own) {
  const OptionDescription common[] = {
      {"schema", "", "SQL that makes the tables of what is missing or empty",
       false},
      {"seed", "", "SQL that fills the tables of what is missing or empty",
       false},
      {"busy-timeout", "2s",
       "how long to wait for others: their writing, their locks, a connection",
       false, OptionType::duration},
      {"transaction-timeout", "30s",
       "after which an open transaction is rolled back", false,
       OptionType::duration},
      {"max-rows", "10000", "the most rows that a query returns", false,
       OptionType::integer},
      {"max-bytes", "4194304", "the most bytes that a query returns", false,
       OptionType::integer},
      {"columns", "",
       "columns whose new values are told; otherwise those of slots and "
       "grammars",
       false},
      {"watch", "300ms",
       "how often to look whether other programs have changed these columns; "
       "0s: never",
       false, OptionType::duration},
  };
  own.insert(own.end(), std::begin(common), std::end(common));
  return own;
}

void read_database_options(OptionReader& read,
                           const std::string& application_folder,
                           DatabaseOptions& made) {
  made.busy_timeout = read.duration("busy-timeout");
  made.transaction_timeout = read.duration("transaction-timeout");
  made.columns = split_at_commas(read.text("columns"));
  made.watch = read.duration("watch");
  made.schema = read.file("schema", application_folder);
  made.seed = read.file("seed", application_folder);
  made.rows = read.count("max-rows", 1);
  made.bytes = read.count("max-bytes", 1);
}

} // namespace parlour::adapters
