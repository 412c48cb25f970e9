// SPDX-License-Identifier: GPL-3.0-or-later
#include "view/colour_map.h"

#include <algorithm>
#include <cmath>

namespace hitscope {

namespace {

using Stops = std::array<std::uint32_t, 33>;  // 0xRRGGBB, sRGB

/// Entries 0, 8, ... 248 and 255 of the 256 that Stefan van der Walt and Nathaniel Smith published (CC0,
/// https://bids.github.io/colormap).
constexpr Stops kViridis{0x440154, 0x470d60, 0x48186a, 0x482374, 0x472d7b, 0x453781, 0x424086,
                         0x3e4989, 0x3b528b, 0x375b8d, 0x33638d, 0x2f6b8e, 0x2c728e, 0x297a8e,
                         0x26828e, 0x23898e, 0x21918c, 0x1f988b, 0x1fa088, 0x22a785, 0x28ae80,
                         0x32b67a, 0x3fbc73, 0x4ec36b, 0x5ec962, 0x70cf57, 0x84d44b, 0x98d83e,
                         0xaddc30, 0xc2df23, 0xd8e219, 0xece51b, 0xfde725};
/// Likewise, of Jamie Nunez, Christopher Anderton and Ryan Renslow, "Optimizing colormaps with consideration
/// for color vision deficiency", PLoS ONE 13(7), 2018.
constexpr Stops kCividis{0x00224e, 0x00285b, 0x002e6a, 0x053371, 0x1a386f, 0x273e6e, 0x32436d,
                         0x3b496c, 0x434e6c, 0x4b546c, 0x535a6d, 0x5a5f6e, 0x61656f, 0x686a71,
                         0x6f7073, 0x767676, 0x7d7c78, 0x848279, 0x8c8878, 0x938e78, 0x9b9476,
                         0xa39a74, 0xaba072, 0xb4a76f, 0xbcae6c, 0xc4b468, 0xcdbb63, 0xd5c25e,
                         0xdec958, 0xe7d150, 0xf0d846, 0xf9e03a, 0xfee838};
/// Kenneth Moreland, "Diverging Color Maps for Scientific Visualization", ISVC 2009: the table of 33 entries
/// of his smooth cool-warm map; the middle is a light grey.
constexpr Stops kCoolWarm{0x3b4cc0, 0x445acc, 0x4d68d7, 0x5775e1, 0x6282ea, 0x6c8ef1, 0x779af7,
                          0x82a5fb, 0x8db0fe, 0x98b9ff, 0xa3c2ff, 0xaec9fd, 0xb8d0f9, 0xc2d5f4,
                          0xccd9ee, 0xd5dbe6, 0xdddddd, 0xe5d8d1, 0xecd3c5, 0xf1ccb9, 0xf5c4ad,
                          0xf7bba0, 0xf7b194, 0xf7a687, 0xf49a7b, 0xf18d6f, 0xec7f63, 0xe57058,
                          0xde604d, 0xd55042, 0xcb3e38, 0xc0282f, 0xb40426};

constexpr int kStopEvery = 8;  // entries of the table of 256, viridis and cividis

const Stops& stopsOf(ColourMap map) {
    switch (map) {
        case ColourMap::Cividis:
            return kCividis;
        case ColourMap::CoolWarm:
            return kCoolWarm;
        case ColourMap::Viridis:
            break;
    }
    return kViridis;
}

std::uint8_t channel(std::uint32_t colour, int index) {
    return static_cast<std::uint8_t>((colour >> (16 - 8 * index)) & 0xffu);
}

std::array<std::uint8_t, 3> between(std::uint32_t a, std::uint32_t b, double part) {
    std::array<std::uint8_t, 3> colour{};
    for (int i = 0; i < 3; ++i) {
        const double mixed = (1.0 - part) * channel(a, i) + part * channel(b, i);
        colour[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(std::lround(mixed));
    }
    return colour;
}

ColourTable makeTable(ColourMap map) {
    const Stops& stops = stopsOf(map);
    ColourTable table{};
    for (int i = 0; i < static_cast<int>(table.size()); ++i) {
        double at = i / 255.0 * 32.0;
        if (map != ColourMap::CoolWarm) {
            const int stop = std::min(i / kStopEvery, 31);
            const int first = stop * kStopEvery;
            const int next = std::min(first + kStopEvery, 255);
            at = stop + static_cast<double>(i - first) / (next - first);
        }
        const auto stop = std::min(static_cast<std::size_t>(at), stops.size() - 2);
        table[static_cast<std::size_t>(i)] =
            between(stops[stop], stops[stop + 1], at - static_cast<double>(stop));
    }
    return table;
}

}  // namespace

const ColourTable& colourTable(ColourMap map) {
    static const std::array<ColourTable, 3> kTables{
        makeTable(ColourMap::Viridis), makeTable(ColourMap::Cividis), makeTable(ColourMap::CoolWarm)};
    return kTables[static_cast<std::size_t>(map)];
}

}  // namespace hitscope
