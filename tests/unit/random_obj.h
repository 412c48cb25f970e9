// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>
#include <random>
#include <string>

namespace hitscope::test {

/// Lines as programs and people write them, in any order.
inline std::string randomObj(std::mt19937& random) {
    const auto below = [&random](int bound) {
        return std::uniform_int_distribution<int>(0, bound - 1)(random);
    };
    const auto pick = [&](std::initializer_list<const char*> words) {
        return std::string(*(words.begin() + below(static_cast<int>(words.size()))));
    };
    const std::string usualEnd = pick({"\n", "\r\n", "\r"});
    const bool isMixed = below(4) == 0;
    const auto lineEnd = [&] { return isMixed ? pick({"\n", "\r\n", "\r"}) : usualEnd; };
    const auto gap = [&] { return pick({" ", " ", " ", "  ", "\t"}) + (below(20) ? "" : "\\" + lineEnd()); };
    std::string text = pick({"", "", "\xEF\xBB\xBF"});
    int vertices = 0;
    int normals = 0;
    const int lines = 10 + below(40);
    for (int i = 0; i < lines || vertices < 3; ++i) {
        const int kind = below(10);
        if (kind < 4 || vertices < 3) {
            text += pick({"v", " v", "v"});
            for (int axis = 0; axis < 3; ++axis) {
                text += gap() + pick({"0", "1.50", "-0.3487989902496338", "1e-3", "+2", "-0", "123456.789"});
            }
            text += pick({"", "", " 1", " 0.5 0.5 1", " # a"});
            ++vertices;
        } else if (kind == 4) {
            text += "vn" + gap() + pick({"0", "0.5"}) + gap() + "1" + gap() + pick({"0", "-3"});
            ++normals;
        } else if (kind < 8) {
            text += "f";
            const int corners = 2 + below(4);
            for (int c = 0; c < corners; ++c) {
                const int v = below(vertices);
                text += gap() + std::to_string(below(3) ? v + 1 : v - vertices);
                if (normals > 0 && below(3)) {
                    const int n = below(normals);
                    text += "//" + std::to_string(below(6) ? n + 1 : n - normals);
                }
            }
            text += pick({"", " ", " # f 1 2 3"});
        } else {
            text += pick(
                {"# comment \\", "", "g a b", "s 1", "vt 0.5 0.50 0", "usemtl x", "o v", "vp 1 2", "l 1 2"});
        }
        text += lineEnd();
    }
    text += "f 1 2 3" + pick({"", "", " \\"}) + pick({"", usualEnd.c_str()});
    return text;
}

}  // namespace hitscope::test
