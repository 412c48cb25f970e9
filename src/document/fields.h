// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace hitscope {

/// What of a type is kept in a file, said once for FieldReader and FieldWriter:
/// `template <class Visit, class T> static void visit(Visit& visit, T& value)`, where T may be const, calls
/// the visitor's functions for each member, in the order in which they are written.
template <class Type>
struct Fields;

}  // namespace hitscope
