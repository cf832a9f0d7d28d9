import './host.ts';
import '../../../panels/diagram/main.ts';
