// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/no_window.h"

#include <QGuiApplication>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace hitscope {

namespace {

// A message handler takes nothing along.
struct Refused {
    const char* program = "";
    QString advice;
    QString reason;  ///< what the platform said first
};
Refused& refused() {
    static auto* const one = new Refused;  // for as long as any thread has something to say
    return *one;
}

void sayWhyThereIsNoWindow(QtMsgType type, const QMessageLogContext& context, const QString& text) {
    const bool isOfPlatform =
        context.category != nullptr && std::string_view(context.category).starts_with("qt.qpa");
    QString& reason = refused().reason;
    if (type == QtFatalMsg) {
        std::_Exit(saysNo(refused().program,
                          QStringLiteral("no window can be opened: %1. %2")
                              .arg(reason.isEmpty() ? text.section(u'\n', 0, 0) : reason, refused().advice)));
    }
    if (isOfPlatform && reason.isEmpty()) {
        reason = text.trimmed();
    } else if (!isOfPlatform) {
        std::fprintf(stderr, "%s\n", qPrintable(text));
    }
}

}  // namespace

int saysNo(const char* program, const QString& why) {
    std::fprintf(stderr, "%s: %s\n", program, qPrintable(why));
    return 1;
}

DisplayRefusal::DisplayRefusal(const char* program, const QString& advice) {
    refused() = {program, advice, {}};
    qInstallMessageHandler(sayWhyThereIsNoWindow);
}

DisplayRefusal::~DisplayRefusal() {
    qInstallMessageHandler(nullptr);
}

QString whyNoWindows() {
    const QString platform = QGuiApplication::platformName();
    const bool hasWindows = platform != QLatin1String("offscreen") &&
                            !platform.startsWith(QLatin1String("minimal")) &&
                            platform != QLatin1String("vnc") && platform != QLatin1String("linuxfb");
    return hasWindows ? QString()
                      : QStringLiteral(
                            "Qt's platform \"%1\" has no windows to draw into. Unset "
                            "QT_QPA_PLATFORM, or set it to xcb or wayland.")
                            .arg(platform);
}

}  // namespace hitscope
