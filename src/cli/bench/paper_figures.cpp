// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/paper_figures.h"

#include <array>

namespace hitscope::bench {

std::span<const PaperFigures> paperTable1() {
    static constexpr std::array<PaperFigures, 9> kTable{{{"15", "60"},
                                                         {"20", "90"},
                                                         {"45", "170"},
                                                         {"20", "70"},
                                                         {"30", "120"},
                                                         {"120", "200-350"},
                                                         {"10", "50"},
                                                         {"15", "70"},
                                                         {"30", "110"}}};
    return kTable;
}

std::span<const PaperFigures> paperTable2() {
    static constexpr std::array<PaperFigures, 9> kTable{{{"170-270", "180-550"},
                                                         {"140-300", "180-740"},
                                                         {"160-320", "200-780"},
                                                         {"110-290", "120-630"},
                                                         {"130-310", "150-700"},
                                                         {"140-340", "150-760"},
                                                         {"130-260", "130-560"},
                                                         {"130-310", "140-630"},
                                                         {"140-310", "160-700"}}};
    return kTable;
}

}  // namespace hitscope::bench
