int unused_sleep;
