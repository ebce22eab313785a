// SPDX-License-Identifier: MIT
#include "penumbra/scene_io/output_file.h"
#include "penumbra/scene_io/write_scene.h"

namespace penumbra {

void write_file(const std::filesystem::path& path, std::string_view bytes) {
  OutputFile file(path);
  file.write(bytes);
  file.finish();
}

}  // namespace penumbra
