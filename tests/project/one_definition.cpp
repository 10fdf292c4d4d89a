/// Links all libraries of all chapters, whole: where types are compared at the link (preset odr), each name has one definition.
int main() {}
