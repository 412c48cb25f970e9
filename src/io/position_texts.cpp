// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/position_texts.h"

#include <algorithm>

#include "io/number_text.h"

namespace hitscope {

void appendPositionLine(std::string& texts, const std::array<std::string_view, 3>& written,
                        const glm::dvec3& position) {
    const std::size_t start = texts.size();
    bool isShortest = true;
    for (int i = 0; i < 3; ++i) {
        const std::string_view text = written[static_cast<std::size_t>(i)];
        if (isShortest) {
            const std::size_t before = texts.size();
            appendNumber(texts, position[i]);
            isShortest = std::string_view(texts).substr(before) == text;
            texts.resize(before);
        }
        texts += text;
        texts += ' ';
    }
    texts.resize(isShortest ? start : texts.size() - 1);
    texts += '\n';
}

std::string_view PositionLines::next() {
    const std::size_t end = std::min(m_rest.find('\n'), m_rest.size());
    const std::string_view line = m_rest.substr(0, end);
    m_rest.remove_prefix(std::min(end + 1, m_rest.size()));
    return line;
}

}  // namespace hitscope
