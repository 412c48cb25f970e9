// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/grid_files.h"

#include <QFile>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>

namespace hitscope::bench {

namespace {

static_assert(std::endian::native == std::endian::little, "numbers are written as they lie in memory");

struct Sheet {
    int wide = 1;  ///< quads
    int high = 1;  ///< quads
};

Sheet sheetOf(int quads) {
    const int wide = std::max(1, static_cast<int>(std::sqrt(static_cast<double>(quads))));
    return {wide, std::max(1, (quads + wide / 2) / wide)};
}

float heightAt(int i, int j) {
    constexpr double kWave = 0.02;
    constexpr double kHigh = 6.0;
    return static_cast<float>(kHigh * std::sin(kWave * i) * std::cos(kWave * j));
}

/// Writes text to a file in large pieces.
class PieceWriter {
public:
    explicit PieceWriter(const QString& path) : m_file(path) {
        m_good = m_file.open(QIODevice::WriteOnly | QIODevice::Unbuffered);
    }
    std::string& text() {
        if (m_text.size() > kPiece) {
            flush();
        }
        return m_text;
    }
    template <class Number>
    void put(Number number) {
        std::array<char, sizeof number> bytes;
        std::memcpy(bytes.data(), &number, sizeof number);
        text().append(bytes.data(), bytes.size());
    }
    Status finish() {
        flush();
        return m_good ? Status(Done{})
                      : Error{"The file for the benchmark cannot be written: " +
                                  m_file.errorString().toStdString() + ".",
                              m_file.fileName().toStdString(),
                              "Make room there, or set TMPDIR to another folder."};
    }

private:
    static constexpr std::size_t kPiece = 1 << 20;

    void flush() {
        const auto size = static_cast<qint64>(m_text.size());
        m_good = m_good && m_file.write(m_text.data(), size) == size;
        m_text.clear();
    }

    QFile m_file;
    std::string m_text;
    bool m_good = false;
};

void writeVertices(PieceWriter& out, const Sheet& sheet) {
    out.text() += "vt 0 0\nvt 1 0\nvt 0 1\nvt 1 1\n";
    for (int n = 0; n < 9; ++n) {  // nearly upwards
        out.text() += "vn " + std::to_string(n % 3 - 1) + " " + std::to_string(n / 3 - 1) + " 9\n";
    }
    for (int j = 0; j <= sheet.high; ++j) {
        for (int i = 0; i <= sheet.wide; ++i) {
            const int tenths = static_cast<int>(std::lround(10.0f * heightAt(i, j)));
            std::string& text = out.text();
            text += "v " + std::to_string(i) + " " + std::to_string(j) + (tenths < 0 ? " -" : " ");
            text +=
                std::to_string(std::abs(tenths) / 10) + "." + std::to_string(std::abs(tenths) % 10) + "\n";
        }
    }
}

}  // namespace

std::size_t gridVertices(int quads) {
    const Sheet sheet = sheetOf(quads);
    return (static_cast<std::size_t>(sheet.wide) + 1) * (static_cast<std::size_t>(sheet.high) + 1);
}

Status writeGridObj(const QString& path, int quads) {
    const Sheet sheet = sheetOf(quads);
    PieceWriter out(path);
    writeVertices(out, sheet);
    constexpr std::array<std::array<int, 2>, 4> kCorners{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    for (int j = 0; j < sheet.high; ++j) {
        for (int i = 0; i < sheet.wide; ++i) {
            std::string& text = out.text();
            text += 'f';
            for (const auto& [right, up] : kCorners) {
                const int a = i + right;
                const int b = j + up;
                text += " " + std::to_string(b * (sheet.wide + 1) + a + 1);
                text += "/" + std::to_string(1 + a % 2 + 2 * (b % 2));
                text += "/" + std::to_string(1 + a % 3 + 3 * (b % 3));
            }
            text += '\n';
        }
    }
    return out.finish();
}

Status writeGridPly(const QString& path, int triangles) {
    const Sheet sheet = sheetOf(triangles / 2);
    const std::int32_t row = sheet.wide + 1;
    PieceWriter out(path);
    out.text() += "ply\nformat binary_little_endian 1.0\nelement vertex " +
                  std::to_string(std::int64_t{row} * (sheet.high + 1)) +
                  "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
                  std::to_string(std::int64_t{2} * sheet.wide * sheet.high) +
                  "\nproperty list uchar int vertex_indices\nend_header\n";
    for (int j = 0; j <= sheet.high; ++j) {
        for (int i = 0; i <= sheet.wide; ++i) {
            out.put(static_cast<float>(i));
            out.put(static_cast<float>(j));
            out.put(heightAt(i, j));
        }
    }
    for (std::int32_t j = 0; j < sheet.high; ++j) {
        for (std::int32_t i = 0; i < sheet.wide; ++i) {
            const std::int32_t at = j * row + i;
            for (const std::array<std::int32_t, 3>& face :
                 {std::array{at, at + 1, at + row + 1}, std::array{at, at + row + 1, at + row}}) {
                out.put(std::uint8_t{3});
                out.put(face);
            }
        }
    }
    return out.finish();
}

}  // namespace hitscope::bench
