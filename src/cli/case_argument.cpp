#include "cli/case_argument.hpp"

#include "cli/options.hpp"
#include "corpus/find_case.hpp"
#include "report/outputs.hpp"

namespace manifuzz {

void add_case_argument(CLI::App& app, CaseArgument& argument) {
  app.add_option("file", argument.name,
                 "a case, - for stdin; or a bucket or the beginning of a file's name in the corpus")
      ->type_name("FILE")
      ->required()
      ->check(not_blank);
  app.add_option("--corpus", argument.corpus, "the folder where a bucket or a beginning is found")
      ->type_name("DIR")
      ->check(not_blank)
      ->capture_default_str();
}

std::string case_file(const CaseArgument& argument) {
  const FoundCase found = find_case(argument.name, argument.corpus);
  if (!found.remark.empty()) write_remark(found.remark);
  return found.file;
}

}  // namespace manifuzz
