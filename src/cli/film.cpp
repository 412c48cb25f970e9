// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/film.h"

#include <signal.h>
#include <sys/prctl.h>

#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QStandardPaths>

#include "cli/standard_streams.h"
#include "io/staged_files.h"

namespace hitscope::cli {

namespace {

QString suffixOf(const QString& path) {
    return QFileInfo(path).suffix().toLower();
}

/// What each format takes; what it cannot hold (odd sizes, opacity) is made to fit.
QStringList encoding(const QString& suffix) {
    if (suffix == QLatin1String("gif")) {
        return {QStringLiteral("-filter_complex"),
                QStringLiteral("[0:v]split[a][b];[a]palettegen[p];[b][p]paletteuse"), QStringLiteral("-f"),
                QStringLiteral("gif")};
    }
    const bool isMp4 = suffix == QLatin1String("mp4");
    return {QStringLiteral("-vf"),  QStringLiteral("pad=ceil(iw/2)*2:ceil(ih/2)*2,format=yuv420p"),
            QStringLiteral("-c:v"), isMp4 ? QStringLiteral("libx264") : QStringLiteral("libvpx-vp9"),
            QStringLiteral("-crf"), isMp4 ? QStringLiteral("18") : QStringLiteral("30"),
            QStringLiteral("-b:v"), QStringLiteral("0"),
            QStringLiteral("-f"),   suffix};
}

}  // namespace

const QStringList& filmSuffixes() {
    static const QStringList suffixes{QStringLiteral("mp4"), QStringLiteral("gif"), QStringLiteral("webm")};
    return suffixes;
}

bool namesFilm(const QString& path) {
    return filmSuffixes().contains(suffixOf(path)) && !QFileInfo(path).isDir();
}

Outcome checkFilm(int width, int height) {
    constexpr int kMostSide = 16384;  // of the encoders
    if (width > kMostSide || height > kMostSide) {
        return cannotDraw({"A film has at most 16384 pixels each way.", "--size", "Choose a smaller one."});
    }
    return QStandardPaths::findExecutable(QStringLiteral("ffmpeg")).isEmpty()
               ? cannotDraw({"A film takes ffmpeg, which is not installed here.", "",
                             "Install ffmpeg, or name a folder for PNG files."})
               : Outcome(Done{});
}

Outcome writeFilm(const QString& first, double rate, const QString& path) {
    const QFileInfo info(first);
    const qsizetype digits = info.completeBaseName().size() - info.completeBaseName().lastIndexOf(u'-') - 1;
    QString pattern = info.absoluteFilePath();
    pattern.replace(pattern.lastIndexOf(u'-') + 1, digits,
                    QStringLiteral("%0") + QString::number(digits) + u'd');
    const QString made = info.absolutePath() + QStringLiteral("/film.") + suffixOf(path);
    QProcess process;
    process.setStandardInputFile(QProcess::nullDevice());
    process.setChildProcessModifier([] { ::prctl(PR_SET_PDEATHSIG, SIGKILL); });
    process.start(
        QStringLiteral("ffmpeg"),
        QStringList{QStringLiteral("-loglevel"), QStringLiteral("error"), QStringLiteral("-y"),
                    QStringLiteral("-framerate"), QString::number(rate), QStringLiteral("-i"), pattern} +
            encoding(suffixOf(path)) + QStringList{made});
    process.waitForFinished(-1);
    if (process.exitStatus() != QProcess::NormalExit || process.exitCode() != 0) {
        const QString said = QString::fromUtf8(process.readAllStandardError()).trimmed();
        return cannotDraw(
            {"ffmpeg could not make the film: " +
                 (said.isEmpty() ? process.errorString() : said.section(u'\n', 0, 0)).toStdString() + ".",
             path.toStdString(), "Try another format."});
    }
    return writeWhole(path, [&made](const PutPiece& put) {
        constexpr qint64 kPiece = 1 << 20;
        QFile film(made);
        bool goesOn = film.open(QIODevice::ReadOnly);
        while (goesOn && !film.atEnd()) {
            const QByteArray piece = film.read(kPiece);
            goesOn = put({piece.constData(), static_cast<std::size_t>(piece.size())});
        }
    });
}

}  // namespace hitscope::cli
