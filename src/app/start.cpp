// SPDX-License-Identifier: Apache-2.0
#include "app/start.hpp"

#include "app/messages.hpp"

namespace thalweg {

bool start(Options& options, std::span<const std::string> arguments, OwnConfiguration configuration) {
  options.parse(arguments);
  if (configuration == OwnConfiguration::yes && !options.text("configuration-file").empty())
    options.take_file(options.text("configuration-file"));
  if (options.answered()) return false;
  configure_messages(options.flag("verbose"), options.text("log"));
  return true;
}

}  // namespace thalweg
