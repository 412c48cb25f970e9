// SPDX-License-Identifier: GPL-3.0-or-later
// What every widget must look like in the light theme and in the dark one.
#include <QApplication>
#include <QCheckBox>
#include <QMessageBox>
#include <QRadioButton>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <memory>

#include "app/dialogs/dialogs.h"
#include "app/theme.h"
#include "support/test_program.h"
#include "window_support.h"

namespace hitscope::theme_test {

namespace {

/// Relative luminance as the accessibility guidelines define it (WCAG 2.1), [0, 1].
double luminance(const QColor& colour) {
    const auto linear = [](double part) {
        return part <= 0.03928 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) +
           0.0722 * linear(colour.blueF());
}

double contrast(const QColor& a, const QColor& b) {
    const double first = luminance(a);
    const double second = luminance(b);
    return (std::max(first, second) + 0.05) / (std::min(first, second) + 0.05);
}

/// The greatest contrast to the window that any pixel of the widget has.
double mostContrast(QWidget& widget) {
    widget.resize(widget.sizeHint());
    const QImage picture = widget.grab().toImage();
    const QColor window = widget.palette().color(QPalette::Window);
    double most = 1.0;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            most = std::max(most, contrast(picture.pixelColor(x, y), window));
        }
    }
    return most;
}

}  // namespace

class ThemeTest : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { QApplication::setStyle(makeStyle()); }
    void cleanup() { applyTheme(ThemeChoice::System); }

    void uncheckedBoxesAreVisible_data() {
        QTest::addColumn<ThemeChoice>("theme");
        QTest::newRow("light") << ThemeChoice::Light;
        QTest::newRow("dark") << ThemeChoice::Dark;
    }

    void uncheckedBoxesAreVisible() {
        QFETCH(const ThemeChoice, theme);
        constexpr double kVisible = 1.6;  // Fusion's own outlines in a light window
        applyTheme(theme);
        QCheckBox box;
        QVERIFY2(mostContrast(box) >= kVisible, qPrintable(QString::number(mostContrast(box))));
        QRadioButton button;
        QVERIFY2(mostContrast(button) >= kVisible, qPrintable(QString::number(mostContrast(button))));
    }

    void errorsHaveATitleOfOneName() {
        QGuiApplication::setApplicationDisplayName(QStringLiteral("Hitscope"));
        QWidget window;
        window.show();
        showError(&window, {"It failed.", "here", "Try again."});
        auto* box = window.findChild<QMessageBox*>();
        QVERIFY(box != nullptr);
        // Qt adds the display name to what is not the display name.
        QCOMPARE(box->windowTitle(), QStringLiteral("Hitscope"));
        QGuiApplication::setApplicationDisplayName({});
    }

    void dialogsStartInAFolderThatExists() {
        const QTemporaryDir folder;
        QCOMPARE(existingFolder(folder.path()), folder.path());
        const QString gone = folder.filePath(QStringLiteral("gone"));
        QVERIFY(existingFolder(gone) != gone);
        QVERIFY(QFileInfo(existingFolder(gone)).isDir());
        QVERIFY(QFileInfo(existingFolder({})).isDir());
    }
};

HITSCOPE_TEST(ThemeTest, QApplication)

}  // namespace hitscope::theme_test

#include "theme_test.moc"
