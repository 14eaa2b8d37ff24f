// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/options.hpp"
#include "cch/order_cache.hpp"

namespace thalweg {

/// --no-cache.
OptionSpec no_cache_option();

/// The user's cache folder ($XDG_CACHE_HOME/thalweg, else ~/.cache/thalweg), warnings to the error stream;
/// nowhere with --no-cache, or when there is no such folder.
OrderCache order_cache(const Options& options);

}  // namespace thalweg
