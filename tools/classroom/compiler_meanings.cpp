#include "pushback/tools/classroom/compiler_meanings.h"

#include <regex>

namespace pushback {

namespace {

struct Meaning {
  const char* said;   ///< a regular expression: g++ first, then clang++
  const char* means;  ///< $1, $2: what stands in the groups
};

/// The first that matches holds.
constexpr Meaning meanings[] = {
    {"expected '?;'?.*|expected (initializer|',' or ';') before.*",
     "a semicolon is missing, there or at the end of the line before."},
    {"expected '?\\}'?.*", "a closing brace } is missing: each { needs one."},
    {"expected '?\\)'?.*", "a closing bracket ) is missing, or a sign before it."},
    {"expected '?\\]'?.*", "a closing bracket ] is missing."},
    {"expected '?\\('?.*", "an opening bracket ( is missing: if, for and while need a pair of brackets."},
    {"'else' without a previous 'if'",
     "this else belongs to no if: is there a ; behind the brackets of the if, or are two lines below it without braces "
     "{ }?"},
    {"expected primary-expression before '([^']*)'.*",
     "something is missing before '$1': a number or a name, on one side of a sign."},
    {"expected expression",
     "something is missing or too much: a number or a name on one side of a sign, an else without its if, or a "
     "bracket."},
    {".*a function-definition is not allowed here.*|function definition is not allowed here.*",
     "a function begins inside another one: the } that ends the one above is missing."},
    {"expected unqualified-id.*|expected declaration.*|expected member name.*|extraneous closing brace.*",
     "something stands where none can, outside of a function: often a brace { or } too many or too few above."},
    {"unterminated (#|conditional).*", "an #if is never closed: each #if needs an #endif."},
    {"unterminated.*comment.*", "a comment is never closed: each /* needs a */."},
    {"missing terminating.*", "a text is never closed: each \" needs another one, in the same line."},
    {"stray '.*|extended character.*|unexpected character.*|non-ASCII characters.*|character <U.*|source file is not "
     "valid UTF-8.*",
     "there is a letter that C++ does not know, often a quote “ ”, a minus – or a × that was copied from a page: type "
     "it anew."},
    {"'answer' is not a member of 'student'.*|.*no member named 'answer' in namespace 'student'.*|.*'?student'? has "
     "not been declared.*|use of undeclared identifier 'student'",
     "the last line of the file is missing, the one that says what your answer is. --reset shows it, in a new copy."},
    {"'([^']*)' is not a member of '(std|Eigen)'.*|no (?:member|type|template) named '([^']*)' in namespace "
     "'(std|Eigen)'.*",
     "$2$4 has nothing called '$1$3'. Is it misspelt, or is the #include of its header missing?"},
    {"'([^']*)' was not declared in this scope.*|use of undeclared identifier '([^']*)'.*|'([^']*)' does not name a "
     "type.*|unknown type name '([^']*)'.*|'([^']*)' has not been declared.*",
     "nothing here has the name '$1$2$3$4$5'. Is it misspelt, or declared further below, or in braces { } that have "
     "ended?"},
    {".*'([^']*)' has no member named '([^']*)'.*", "a $1 has nothing called '$2'. Is it misspelt?"},
    {"no member named '([^']*)' in '([^']*)'.*", "a $2 has nothing called '$1'. Is it misspelt?"},
    {"([^: ]*): No such file or directory|'([^']*)' file not found",
     "there is no file $1$2 here. A solution includes headers of Pushback and of the standard library, and nothing "
     "else."},
    {"invalid use of member function.*|invalid use of non-static member function.*|reference to non-static member "
     "function must be called.*",
     "a function is named, but not called: it needs brackets () behind its name."},
    {".*cannot be used as a function.*|called object type '.*' is not a function.*|type '.*' does not provide a call "
     "operator",
     "what stands before the brackets ( ) is no function: is a * missing, or are the brackets too much?"},
    {"lvalue required.*|expression is not assignable.*|assignment to cast is illegal.*",
     "the left side of = has to be a variable; this is a value that is worked out, and cannot be changed."},
    {"(?:assignment|increment|decrement) of.*read-only.*|cannot assign to .*const.*|passing 'const .*discards "
     "qualifiers.*|'this' argument to member function .*is not marked const|binding reference of type .*discards "
     "qualifiers.*|binding reference of type .* to value of type .* drops 'const' qualifier",
     "what is const cannot be changed."},
    {"no matching function for call to '(?:std::)?(max|min|clamp)\\(.*|no matching function for call to "
     "'(?:std::)?(max|min|clamp)'.*",
     "$1$2 needs values of one kind: 0 is a whole number and 0.5 a double, so write Real(0), Real(0.5)."},
    {"too few arguments to function.*|too few arguments to (?:member )?function call.*|too few arguments .*",
     "this function needs more values in its brackets."},
    {"too many arguments to function.*|too many arguments to (?:member )?function call.*|too many arguments .*",
     "this function takes fewer values in its brackets."},
    {"no matching function for call.*|no matching (?:member function|constructor).*",
     "there is a function of this name, but none that takes these values: are they too many, too few, or of another "
     "kind, a vector for a number?"},
    {"base operand of '->' has non-pointer type.*|member reference type '.*' is not a pointer.*",
     "-> is for pointers; here a dot is needed."},
    {"request for member '.*' in '.*', which is of pointer type.*|member reference type '.*' is a pointer.*",
     "a dot is for things; this is a pointer, and needs ->."},
    {"request for member '([^']*)' in '.*', which is of non-class type.*|member reference base type '.*' is not a "
     "structure or union.*",
     "what stands before the dot is a plain number, and has no parts."},
    {"no match for 'operator\\[\\]'.*|invalid types '.*' for array subscript|subscripted value is not.*|type '.*' does "
     "not provide a subscript operator",
     "what stands before the [ ] is no list."},
    {"invalid operands .*(?:operator)?[\\^%].*|invalid operands to binary expression \\('(?:double|float|.*Real)'.*",
     "^ and % are not for numbers with a point: x * x is a square, std::pow and std::fmod are the rest."},
    {"(?:no match for|ambiguous overload for) 'operator.*|invalid operands.*|use of overloaded operator .* is "
     "ambiguous.*",
     "the two sides of this operator do not go together: a vector and a number, maybe?"},
    {"(?:static assertion failed|static_assert failed|static assertion failed due to "
     "requirement).*(?:YOU_MIXED|INVALID_VECTOR|THIS_METHOD|INVALID_MATRIX|YOU_CANNOT).*",
     "vectors and matrices of different shapes do not go together."},
    {"return-statement with a value, in function returning 'void'.*|void function '.*' should not return a value.*",
     "this function gives nothing back: return stands alone in it."},
    {"return-statement with no value.*|non-void function '.*' should return a value.*|no return statement.*|.*non-void "
     "function does not return.*",
     "a function that should give a value back does not."},
    {"void value not ignored.*|variable has incomplete type 'void'|invalid use of void "
     "expression|.*(?:initialize|assigning).*of type 'void'.*|assigning to '.*' from incompatible type 'void'",
     "this function gives no value back, so there is nothing to be kept or reckoned with."},
    {"narrowing conversion of.*|.*cannot be narrowed to.*",
     "in braces { } a number must not lose its digits: write int(x), or Real(x)."},
    {"cannot bind non-const lvalue reference.*|non-const lvalue reference to type .*cannot bind to a "
     "temporary.*|non-const lvalue reference .*",
     "a & that may be changed needs a variable on the other side, not a value that is worked out."},
    {"(?:cannot convert|could not convert|conversion from|no viable conversion|no known conversion|no viable "
     "overloaded '='|cannot initialize|assigning to|invalid conversion|invalid user-defined conversion).*",
     "a value of one kind stands where another kind is needed: a vector for a number, maybe?"},
    {"'.*' declared as reference but not initialized|declaration of reference variable '.*' requires an initializer",
     "a & has to say at once what it stands for: auto& row = ..."},
    {"uninitialized 'const .*|default initialization of an object of const type.*",
     "what is const needs its value at once."},
    {"redefinition of.*|redeclaration of.*|conflicting declaration.*|declaration of '.*' shadows a "
     "parameter.*|.*cannot be overloaded with.*|class member cannot be redeclared|.*with a different type.*",
     "the same name is declared twice."},
    {"'([^']*)' is not captured.*|variable '([^']*)' cannot be implicitly captured.*",
     "this lambda does not know '$1$2': begin it with [&]."},
    {".*is private within this context.*|.*is a private member of.*|.*is protected within this context.*|.*is a "
     "protected member of.*",
     "this part is not for use from outside."},
    {"(break|continue) statement not within.*|'(break|continue)' statement not in.*",
     "$1$2 is for loops, and there is none around it."},
    {"invalid use of '::'.*", "something above has not ended: a bracket or a semicolon is missing."},
    {"use of '([^']*)' before deduction of 'auto'.*|variable '([^']*)' declared with deduced type 'auto' cannot appear "
     "in its own initializer.*",
     "'$1$2' is used while it is being made."},
};

}  // namespace

std::string meaning_of(const std::string& error) {
  for (const Meaning& meaning : meanings) {
    std::smatch parts;
    if (std::regex_match(error, parts, std::regex(meaning.said))) return parts.format(meaning.means);
  }
  return {};
}

}  // namespace pushback
