import './host.ts';
import '../../../panels/scene/main.ts';
