// SPDX-License-Identifier: GPL-3.0-or-later
#version 330 core
// For passes that leave nothing but depth.

void main()
{
}
