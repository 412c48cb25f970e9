// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <initializer_list>

namespace hitscope {

// Files and folders that are being written under names that nobody is to see: for a program that is to end in
// the middle of it. On any thread.

void notePending(const QByteArray& path);
void forgetPending(const QByteArray& path);  ///< it has its name, or is gone
void noteNewFolder(const QByteArray& path);  ///< made for them: goes if it is empty then
void forgetNewFolder(const QByteArray& path);
void removePendingFiles();  ///< from the disk, folders with all that is in them

/// From now on these signals end the program as they do without this, after removePendingFiles(). Those that
/// whoever started it has switched off stay so. Once, in main().
void removePendingFilesAt(std::initializer_list<int> signals);

}  // namespace hitscope
