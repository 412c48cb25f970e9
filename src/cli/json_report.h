// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"

namespace hitscope::cli {

/// What a verb reports as JSON, in the order it is said: an object with "report" first, the verb's name.
/// Numbers have the fewest digits that read back as the same bits; what is no number is null.
class JsonReport {
public:
    explicit JsonReport(std::string_view verb);

    // Keys are of objects; elements of arrays have none.
    JsonReport& beginObject(std::string_view key = {});
    JsonReport& endObject();
    JsonReport& beginArray(std::string_view key = {});
    JsonReport& endArray();
    JsonReport& text(std::string_view key, const QString& value);
    JsonReport& count(std::string_view key, std::uint64_t value);
    JsonReport& number(std::string_view key, float value);
    JsonReport& number(std::string_view key, double value);
    JsonReport& number(std::string_view key, const std::optional<double>& value);  ///< nothing: null
    JsonReport& truth(std::string_view key, bool value);
    JsonReport& nothing(std::string_view key);
    JsonReport& vector(std::string_view key, const glm::vec3& value);  ///< [x, y, z], on one line
    JsonReport& vector(std::string_view key, const glm::dvec3& value);
    /// A value that is JSON already.
    JsonReport& raw(std::string_view key, std::string_view json);

    /// The whole report; nothing can be added after it.
    [[nodiscard]] std::string take();

private:
    void begin(std::string_view key);
    void open(std::string_view key, char bracket);
    void close(char bracket);
    template <class Number>
    void append(Number value);
    template <class Vector>
    JsonReport& append(std::string_view key, const Vector& value);

    std::string m_text;
    std::vector<bool> m_isEmpty;  ///< one an open bracket
};

/// "text" with its quotes, escaped.
[[nodiscard]] std::string jsonText(const QString& text);

}  // namespace hitscope::cli
