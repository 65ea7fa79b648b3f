/* The code that draws the curves is dygraphs, https://dygraphs.com:
Copyright (c) 2006-2017 Dan Vanderkam; 2011 Paul Felix; 2011, 2013 Robert Konigsberg; 2013 David Eberlein, Google, Inc.;
2014 mirabilos; 2015 Petr Shevtsov; 2022, 2023 mirabilos, Deutsche Telekom LLCTO; and numerous contributors.
Its module shim: Copyright (c) 2013, 2014 James Halliday; 2013 Roman Shtylman, Esa-Matti Suuronen; 2018 Philipp Simon
Schmidt.

Permission is hereby granted, free of charge, to any person obtaining a copy of this software and associated documentation
files (the "Software"), to deal in the Software without restriction, including without limitation the rights to use, copy,
modify, merge, publish, distribute, sublicense, and/or sell copies of the Software, and to permit persons to whom the
Software is furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in all copies or substantial portions of the
Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR IMPLIED, INCLUDING BUT NOT LIMITED TO THE
WARRANTIES OF MERCHANTABILITY, FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE AUTHORS OR
COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE,
ARISING FROM, OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE SOFTWARE. */
