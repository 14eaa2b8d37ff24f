// SPDX-License-Identifier: Apache-2.0
#include "simulation/sumo_module.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <filesystem>

#include "core/error.hpp"

namespace thalweg {
namespace {

void* module_symbol(const char* name) {
  static void* const module = [] {
    const auto file = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "thalweg_sumo.so";
    void* handle = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (handle == nullptr) {
      throw InputError(fmt::format(
          "SUMO's library cannot be loaded: {}\n  'tools/setup' installs SUMO, 'tools/build' builds against "
          "it, 'thalweg doctor' tells more.",
          dlerror()));
    }
    return handle;
  }();
  void* symbol = dlsym(module, name);
  verify(symbol != nullptr, "thalweg_sumo.so is of another version: build again with tools/build");
  return symbol;
}

}  // namespace

std::unique_ptr<Simulation> open_sumo(const SessionSetup& setup) {
  const auto open = reinterpret_cast<decltype(&thalweg_open_sumo)>(module_symbol("thalweg_open_sumo"));
  return std::unique_ptr<Simulation>(open(setup));
}

std::string sumo_library_version() {
  const auto version =
      reinterpret_cast<decltype(&thalweg_sumo_version)>(module_symbol("thalweg_sumo_version"));
  return version();
}

}  // namespace thalweg
