// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/scene_options.h"

#include <limits>

#include "cli/common_options.h"

namespace hitscope::cli {

UsageOption untilOption() {
    return valueOption("until", "N", QStringLiteral("Apply only the first N hits of a session."));
}

SceneWish givenScene(Invocation& given, const QString& path) {
    SceneWish wish{.path = path, .pipeline = givenPipeline(given)};
    if (given.isSet("until")) {
        wish.until = static_cast<std::size_t>(given.wholeNumber("until", 0, std::numeric_limits<int>::max()));
        if (!namesSession(wish.path)) {
            given.complain(QStringLiteral("--until goes with a session."));
        }
    }
    return wish;
}

}  // namespace hitscope::cli
