int main(void) {
  /* [loop] */
  for (;;) {
    step();
  }
  /* [loop] */
}
